#lang mechanics
;; A section of the rapidly driven pendulum  (SICM 3.6.1, Figure 3.14)
;;
;; A = 0.2 m, ω = 10.1 ω₀: shaken so fast the pendulum can stand upright. About the angle π there
;; is an island of orbits that do not fall, as wide as the mean over a period says.

(require mechanics/plot "strobe.rkt")

(define T (strobe-map 0.2 10.1))
(define win
  (strobe-section 0.2 10.1 20.
                  '((3. 0.) (2.8 0.) (2.6 0.) (2.4 0.) (0.4 0.) (0.8 0.) (1.2 0.)
                    (0. 9.) (0. 13.) (0. -13.) (0. 18.) (0. -18.))
                  300))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-3-14.png"))

(module+ test
  (require rackunit)
  (define g 9.8)
  (define A*omega (* 0.2 10.1 (sqrt g)))
  (define turned (principal-value :pi))
  ;; How far from upright an orbit is at most, of n periods from (θ, 0).
  (define (farthest theta n)
    (for/fold ([most 0.] [theta theta] [p 0.] #:result most) ([k n])
      (T theta p (lambda (theta p) (values (max most (abs (turned (- theta :pi)))) theta p)) void)))
  (define upright (find-fixed-point T (up :pi 0.)))
  (test-case "upright it is stable, and so it is hanging"
    (check-equal? (fixed-point-kind upright) 'elliptic)
    (check-equal? (fixed-point-kind (find-fixed-point T (up 0. 0.))) 'elliptic))
  (test-case "it swings about the top at nearly the frequency of the mean potential"
    (define turns (rotation-value (rotation-number T (up 3.1 0.) 400 #:about (up :pi 0.))))
    (check-= (* 2 (cos (* :2pi turns))) (apply + (fixed-point-multipliers upright)) 1e-3)
    (define slow (sqrt (- (/ (square A*omega) 2) g)))
    (check-= (abs turns) (/ slow (* 10.1 (sqrt g))) 0.01))
  (test-case "the mean has its barrier where cos θ = −2 g l / (A ω)²: inside an orbit stays"
    (define barrier (- :pi (acos (/ (* -2 g) (square A*omega)))))
    ;; at the phase 0 the pendulum is a little farther out than in the mean
    (define edge (+ barrier (* 0.2 (sin barrier))))
    (check-true (< (farthest (- :pi (* 0.7 edge)) 300) edge))
    (check-true (> (farthest (- :pi (* 1.2 edge)) 300) 2.))))
