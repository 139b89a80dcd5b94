#lang mechanics
;; Exercise 7.3 (SICM 7.4.1): the resonance Hamiltonian
;; Checked: what the generator without the resonant wave leaves to the first order
;; How: Lie derivatives by hand, beside perturbation-series

(define (rotor-and-clock (up t q (down P p))) (+ (/ (square p) (* 2 'alpha)) (* 'omega P)))
(define (waves (up t (up phi theta) p))
  (+ (* -1 'beta (cos theta))
     (* 'gamma (+ (cos (+ theta phi)) (cos (- theta phi))))))
(define state (up 's (up 'phi 'theta) (down 'P 'p)))

;; (7.74): the terms that remove gravity and the wave θ + φ
(define (rate p) (/ p 'alpha))
(define (W-0 (up t (up phi theta) (down P p))) (* -1 (/ 'beta (rate p)) (sin theta)))
(define (W-minus (up t (up phi theta) (down P p)))
  (* (/ 'gamma (+ (rate p) 'omega)) (sin (+ theta phi))))
(define (W-plus (up t (up phi theta) (down P p)))
  (* (/ 'gamma (- (rate p) 'omega)) (sin (- theta phi))))

;; The first order of exp(ε L_W)(H₀ + ε H₁)
(define (first-order W) (+ (((Lie-derivative W) rotor-and-clock) state) (waves state)))
(define kept (* 'gamma (cos (- 'theta 'phi))))
(define right (verify-equal (first-order (+ W-0 W-minus)) kept))
right

;; By the library
(define P (perturbation-series rotor-and-clock waves state #:keep '((-1 1))))
(define same
  (list (verify-equal ((car (perturbation-generators P)) state) ((+ W-0 W-minus) state))
        (verify-equal (series:ref ((perturbation-Hamiltonian P) state) 1) (* 'epsilon kept))))
same

;; The slip: the other wave left out.
(define slip (verify-equal (first-order (+ W-0 W-plus)) kept))
(verdict-residual slip)

(module+ test
  (require rackunit)
  (test-case "(7.76)"
    (check-pred proved? right)
    (for ([v same]) (check-pred proved? v)))
  (test-case "what the other generator leaves"
    (check-pred refuted? slip)
    (check-pred proved? (verify-equal (first-order (+ W-0 W-plus))
                                      (* 'gamma (cos (+ 'theta 'phi)))))))
