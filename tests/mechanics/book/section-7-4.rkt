#lang racket/base
;; SICM 7.3 to 7.5: resonances of the driven pendulum, and the pendulum on its head
;; (pp. 479-494).

(require mechanics
         "../support/checks.rkt" "../support/close.rkt" "../support/session.rkt")

(define state (up 's (up 'phi 'theta) (down 'P 'p)))

;; ---------------------------------------------------------------------------
;; 7.4

(define ((rotor alpha omega) (up t q (down P p))) (+ (/ (square p) (* 2 alpha)) (* omega P)))

(define ((waves beta gamma) (up t (up phi theta) p))
  (+ (* -1 beta (cos theta))
     (* gamma (+ (cos (+ theta phi)) (cos (- theta phi))))))

(test-case "the wave of a resonance is kept; what is left depends on its angle alone"
  (for ([k '((0 1) (1 1) (1 -1))])
    (define P (perturbation-series (rotor 'alpha 'omega) (waves 'beta 'gamma) state
                                   #:order 2 #:keep (list k)))
    (check-pred proved? (verify-perturbation P))
    ;; multiples of the one that is kept, in the second order, too
    (for ([r (perturbation-resonances P)])
      (check-equal? 0 (- (* (car (cadr r)) (cadr k)) (* (cadr (cadr r)) (car k)))))
    (define (along dphi dtheta)
      (define (at x)
        (define angles (up (+ 'phi (* x dphi)) (+ 'theta (* x dtheta))))
        (series:sum ((perturbation-Hamiltonian P) (up 's angles (down 'P 'p))) 2))
      ((D at) 0))
    ;; along the direction in which its angle does not change
    (check-identity (along (cadr k) (- (car k))) 0)))

;; The resonances of figure 7.9's pendulum, α = β = 1, γ = 1/4, ω = 5: do they overlap?
(test-case "the resonances of figure 7.9 do not overlap"
  (define here (up 0 (up 0 0) (down 0 0.0)))
  (define (center k) (resonance-center (rotor 1 5) k here 1))
  (define (width k) (ref (resonance-width (rotor 1 5) (waves 1 1/4) k here) 1))
  (check-close (map center '((0 1) (1 -1) (1 1))) '(0 5 -5) 1e-12)
  (check-close (map width '((0 1) (1 -1) (1 1))) '(2 1 1) 1e-12)
  (check-true (< (+ (width '(0 1)) (width '(1 -1))) (center '(1 -1)))))

;; Against the motion: at strobe times a pendulum within the width stays about the resonance.
(test-case "what starts within the width of p = ω goes along with the drive"
  (define ((flow) (up t theta p))
    (up 1 p (+ (* -1 (sin theta)) (* 1/2 (sin theta) (cos (* 5 t))))))
  (define period (/ (* 2 pi) 5))
  (define (mean-rate p)
    (define end ((state-advancer flow) (up 0 pi p) (* 40 period) 1e-10))
    (/ (- (coordinate end) pi) (* 40 period)))
  (check-close (mean-rate 5.2) 5.0 0.1)
  (check-true (> (abs (- (mean-rate 6.8) 5.0)) 0.5)))

;; ---------------------------------------------------------------------------
;; 7.5

(define (clock (up t q (down P p))) (* 'omega P))

(define (shaken (up t (up phi theta) (down P p)))
  (+ (/ (square p) (* 2 'alpha))
     (* -1 'beta (cos theta))
     (* 'gamma (cos theta) (cos phi))))

(test-case "the averaged Hamiltonian: γ² sin²θ/(4αω²) of effective potential"
  (define P (perturbation-series clock shaken state #:order 3 #:parameter 1))
  (check-pred proved? (verify-perturbation P))
  (define (potential theta)
    (series:sum ((perturbation-Hamiltonian P) (up 0 (up 0 theta) (down 0 0))) 3))
  (check-identity (- (potential 'theta) (potential 0))
                  (+ (* 'beta (- 1 (cos 'theta)))
                     (/ (* (square 'gamma) (square (sin 'theta)))
                        (* 4 'alpha (square 'omega))))))

;; The book's estimate (ω/ω₀)(A/l) > √2, against the multipliers of the period map.
(test-case "the pendulum on its head, by its period map"
  (define omega (* 100 (sqrt 9.8)))
  (define (trace-at-the-top A)
    (define ((flow) (up t theta p))
      (up 1 p (* -1 (- 9.8 (* A (square omega) (cos (* omega t)))) (sin theta))))
    (trace (qp-submatrix
            ((D-as-matrix (lambda (s) ((state-advancer flow) s (/ (* 2 pi) omega) 1e-12)))
             (up 0 pi 0.0)))))
  (check-close (trace-at-the-top 0.03) 1.98618058754 1e-7)
  (define critical (/ (sqrt 2.0) 100))
  (check-true (> (trace-at-the-top (* 0.98 critical)) 2))
  (check-true (< (trace-at-the-top (* 1.02 critical)) 2)))
