#lang racket/base
;; SICM 6.1, the Hamilton-Jacobi equation (pp. 411-425).

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/messages.rkt" "../support/session.rkt")

(define (S-free t q) (- (* 'P q) (/ (* (square 'P) t) (* 2 'm))))

(test-case "the free particle, by a constant momentum and by where it began"
  (check-prints ((Hamilton-Jacobi-residual (H-free 'm) S-free) 't 'q) 0)
  (check-pred proved? (verify-Hamilton-Jacobi (H-free 'm) S-free 't 'q))
  (check-pred proved? (verify-Hamilton-Jacobi
                       (H-free 'm) (lambda (t q) (/ (* 'm (square (- q 'a))) (* 2 t))) 't 'q)))

;; p. 413: S of the oscillator between two places, its action.
(test-case "the oscillator's action solves the equation"
  (define (S t q)
    (define omega 'omega)
    (/ (* 'm omega (- (* (+ (square q) (square 'a)) (cos (* omega t))) (* 2 'a q)))
       (* 2 (sin (* omega t)))))
  (check-pred proved? (verify-Hamilton-Jacobi (H-harmonic 'm (* 'm (square 'omega))) S 't 'q))
  (check-pred refuted? (verify-Hamilton-Jacobi (H-harmonic 'm (* 2 'm (square 'omega))) S 't 'q)))

(test-case "and generates the motion: the old state, a time t after the new one"
  (define (F t q q0)
    (define-values (c s) (values (cos (* 'omega t)) (sin (* 'omega t))))
    (/ (* 'm 'omega (- (* (+ (square q) (square q0)) c) (* 2 q q0))) (* 2 s)))
  (check-identity ((F1->C F) (up 't 'q0 'p0))
                  (up 't
                      (+ (* 'q0 (cos (* 'omega 't)))
                         (* (/ 'p0 (* 'm 'omega)) (sin (* 'omega 't))))
                      (- (* 'p0 (cos (* 'omega 't)))
                         (* 'm 'omega 'q0 (sin (* 'omega 't))))))
  (check-identity ((+ (compose (H-harmonic 'm (* 'm (square 'omega))) (F1->C F)) (F1->K F))
                   (up 't 'q0 'p0))
                  0))

(test-case "a central field in polar coordinates: what is left is a square root"
  (define H (compose (H-central 1 (lambda (r) (/ 'k (square r)))) (F->CH p->r)))
  ;; W = ∫ √(2E − (L² + 2k)/r²) dr + L φ; its derivatives are what the equation asks for
  (define W (literal-function 'W))
  (define (S t q) (+ (W (ref q 0)) (* 'L (ref q 1)) (* -1 'E t)))
  (check-identity ((Hamilton-Jacobi-residual H S) 't (up 'r 'phi))
                  (- (+ (/ (square ((D W) 'r)) 2) (/ (square 'L) (* 2 (square 'r)))
                        (/ 'k (square 'r)))
                     'E)))

(says
 [(verify-Hamilton-Jacobi (H-free 'm) (lambda (q) q) 't 'q)
  "verify-Hamilton-Jacobi: Hamilton's principal function takes the time and the coordinates, "
  "(S t q); given a function without a name, which takes 1 argument"]
 [(verify-Hamilton-Jacobi (H-free 'm) S-free 't 't)
  "verify-Hamilton-Jacobi: the time and coordinates must be made of symbols, each there once, "
  "to stand for any state\n  given: (up t t)\n  more than once: t"])
