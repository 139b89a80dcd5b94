#lang mechanics
;; A plane pendulum in rectangular coordinates: the rod is a constraint, its pull the
;; multiplier (SICM 1.6.2 and 1.10).

(define ((L-mass m g) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (* m g y)))
(define ((rod-of-length l) t q) (- (sqrt (square q)) l))
(define rod (holonomic (rod-of-length 'l)))
(define L (L-mass 'm 'g))
(assume '(> l 0))

;; m ẍ = λ x/l, m ÿ = −m g + λ y/l
(((constrained-Lagrange-equations L rod)
  (up (literal-function 'x) (literal-function 'y)) (literal-function 'lambda))
 't)

;; In terms of the angle θ from the bottom: the tension −λ is m l θ̇² + m g cos θ, and what is
;; left without it is the equation of the angle.
(define (from-bottom local)
  (define θ (coordinate local))
  (up (* 'l (sin θ)) (* -1 'l (cos θ))))
(define tension
  (- (ref ((constrained-accelerations L rod) ((F->C from-bottom) (up 't 'θ 'θdot))) 1)))
tension
(((eliminate-multipliers L rod from-bottom) (literal-function 'θ)) 't)
(((Lagrange-equations (compose L (F->C from-bottom))) (literal-function 'θ)) 't)

;; A hundred swings.
(define (pendulum m l g)
  (constrained-state-derivative (L-mass m g) (holonomic (rod-of-length l))))
(define start (up 0 (up (sin 1) (- (cos 1))) (up 0 0)))
(define swings (evolve-trajectory (pendulum 1 1 9.8) start 214.02287190180931))
(define (greatest f)
  (for/fold ([most 0]) ([k 2001]) (max most (abs (f (swings (* k 0.107)))))))
(define drift (greatest (lambda (s) ((rod-of-length 1) 0 (coordinate s)))))
(define energy (Lagrangian->energy (L-mass 1 9.8)))
(define energy-error (greatest (lambda (s) (- (energy s) (energy start)))))
(printf "drift ~a, error of the energy ~a\n" drift energy-error)

(module+ test
  (require rackunit)
  (test-case "the tension"
    (check-eq? (verdict-status
                (verify-equal tension (+ (* 'm 'l (square 'θdot)) (* 'm 'g (cos 'θ)))))
               'proved))
  (test-case "the angle's equation, both ways"
    (check-eq? (verdict-status
                (verify-equal
                 (((eliminate-multipliers L rod from-bottom) (literal-function 'θ)) 't)
                 (up (((Lagrange-equations (compose L (F->C from-bottom))) (literal-function 'θ))
                      't)
                     0)))
               'proved))
  (test-case "the rod keeps its length"
    (check-true (< drift 1e-13))
    (check-true (< energy-error 5e-8))))
