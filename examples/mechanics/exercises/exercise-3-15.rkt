#lang mechanics
;; Exercise 3.15 (SICM 3.11): surfaces of section of spin and orbit
;; Checked: the synchronous resonance of a small e, and chaos for a body like Hyperion
;; How: a strobe map at the passage of the pericentre; exponents and rotation numbers

;; With the true anomaly f as clock, for time cannot be had in closed form: C = 1, n = 1, and
;; 1/r³ = (1 + e cos f)³/(1 − e²)³, df/dt = (1 + e cos f)²/(1 − e²)^(3/2).
;; State (up f θ p): θ' = p/f', p' = −(ε²/2) sin 2(θ − f)/r³ / f'.
(define ((spin epsilon e) (up f theta p))
  (define reach (+ 1 (* e (cos f))))
  (define rate (/ (square reach) (expt (- 1 (square e)) 3/2)))
  (define cubed (expt (/ reach (- 1 (square e))) 3))
  (up 1
      (/ p rate)
      (/ (* -1/2 (square epsilon) cubed (sin (* 2 (- theta f)))) rate)))

;; One orbit later, at the pericentre.  The body looks the same after half a turn.
(define half-turn (principal-value (/ :pi 2)))
(define (strobe epsilon e)
  (define orbit-later (stroboscopic-map (spin epsilon e) :2pi))
  (lambda (theta p return fail)
    (define next (orbit-later (up 0 theta p)))
    (return (let ([x (- (coordinate next) :2pi)])
              (- x (* :pi (round (/ x :pi)))))
            (momentum next))))

;; The Moon, e = 0: the pendulum in 2θ, with small librations of frequency ε.
(define moon (strobe 0.026 0))
(define at-rest (find-fixed-point moon (up 0.01 1.001)))
(fixed-point-coordinates at-rest)
(define attempt (* :2pi 0.026))
(define slip (* :pi 0.026))
(list (fixed-point-rotation-angle at-rest) attempt)

;; With a real e the centre is forced to rotate unevenly: p at the pericentre is not 1.
(define forced (find-fixed-point (strobe 0.026 0.05) (up 0 1.)))
(define uneven (- (ref (fixed-point-coordinates forced) 1) 1))
uneven

;; Hyperion: ε = 0.89, e = 0.1.  Large-scale chaos around the synchronous state.
(define hyperion (strobe 0.89 0.1))
(define growth (maximal-Lyapunov-exponent hyperion (up 1. 1.05) 200))
(define exponent (car (Lyapunov-values growth)))
(> exponent 0.2)

(module+ test
  (require rackunit)
  (test-case "librations of the Moon"
    (check-= (ref (fixed-point-coordinates at-rest) 1) 1 1e-9)
    (check-= (fixed-point-rotation-angle at-rest) attempt 1e-6)
    (check-true (> (abs (- (fixed-point-rotation-angle at-rest) slip)) 0.05)))
  (test-case "an eccentric orbit forces the rotation"
    (check-equal? (fixed-point-kind forced) 'elliptic)
    ;; −2 ε² e, to first order
    (check-= uneven (* -2 (square 0.026) 0.05) 1e-5))
  (test-case "areas are kept, and Hyperion tumbles"
    (check-= (fixed-point-determinant forced) 1 1e-9)
    (check-true (> exponent 0.2))))
