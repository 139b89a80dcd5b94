#lang mechanics
;; A pendulum that swings in space, by its string
;;
;; The bob has rectangular coordinates, z upwards; the length of the string is a
;; constraint.  Its multiplier is minus the tension.

(require mechanics/plot)
(provide picture)

(define ((L-bob m g) (up t (up x y z) (up vx vy vz)))
  (- (* 1/2 m (+ (square vx) (square vy) (square vz))) (* m g z)))
(define (string l) (holonomic (lambda (t q) (- (sqrt (square q)) l))))

;; The tension, for any motion that keeps the length: θ is counted from the vertical.
(define ((on-sphere l) (up t (up θ φ) (up vθ vφ)))
  (up (* l (sin θ) (cos φ)) (* l (sin θ) (sin φ)) (* -1 l (cos θ))))
(assume '(> l 0))
(define state ((F->C (on-sphere 'l)) (up 't (up 'θ 'φ) (up 'θdot 'φdot))))
(define tension
  (* -1 (ref ((constrained-accelerations (L-bob 'm 'g) (string 'l)) state) 1)))
tension
(verify-equal tension
              (+ (* 'm 'g (cos 'θ)) (/ (* 'm (square (velocity state))) 'l)))

;; A circle at the angle α: at which angular velocity, and with which multiplier?
(define (circle t)
  (up (* 'l (sin 'α) (cos (* 'ω t))) (* 'l (sin 'α) (sin (* 'ω t))) (* -1 'l (cos 'α))))
(define ((verdict-for g) multiplier)
  (verify-solution (L-bob 'm g) circle #:constraints (string 'l) #:multipliers multiplier))
((verdict-for (* 'l (square 'ω) (cos 'α))) (lambda (t) (* -1 'm 'l (square 'ω))))

;; The frequency of small swings in a plane will not do, but where cos α is 1.
((verdict-for (* 'l (square 'ω))) (lambda (t) (* -1 'm 'l (square 'ω))))

;; Launched sideways, a little slower than for the circle: an oval that turns.
(define (swing-from angle sideways)
  (evolve-trajectory (constrained-state-derivative (L-bob 1 9.8) (string 1))
                     ((F->C (on-sphere 1)) (up 0. (up angle 0.) (up 0. sideways)))
                     20. #:tolerance 1e-12))
(define swing (swing-from 1. 2.))
(define (part k) (lambda (state) (ref (coordinate state) k)))

(define picture
  (frame -0.9 0.9 -0.9 0.9 #:aspect-ratio 'equal #:x-label "x" #:y-label "y"))
(plot-trajectory picture swing (part 0) (part 1))
picture

(module+ main
  (require "../figures/save.rkt")
  (save-figure picture "conical-pendulum.png"))

(module+ test
  (require rackunit)
  (define-syntax-rule (check-status status verdict)
    (check-eq? (verdict-status verdict) status))
  (test-case "the tension"
    (check-status 'proved
                  (verify-equal tension
                                (+ (* 'm 'g (cos 'θ))
                                   (* 'm 'l (+ (square 'θdot)
                                               (square (* (sin 'θ) 'φdot))))))))
  (test-case "the circle has one angular velocity, and one tension"
    (check-status 'proved ((verdict-for (* 'l (square 'ω) (cos 'α)))
                           (lambda (t) (* -1 'm 'l (square 'ω)))))
    (check-status 'refuted ((verdict-for (* 'l (square 'ω)))
                            (lambda (t) (* -1 'm 'l (square 'ω)))))
    (check-status 'refuted ((verdict-for (* 'l (square 'ω) (cos 'α)))
                            (lambda (t) (* -1 'm 'g)))))
  (test-case "is there any multiplier?"
    (define (status g)
      (verdict-status
       (verify-solution (L-bob 'm g) circle #:constraints (string 'l))))
    (check-eq? (status (* 'l (square 'ω) (cos 'α))) 'proved)
    (check-eq? (status 'g) 'refuted))
  (test-case "length, energy and angular momentum are kept for twenty seconds"
    (define energy (Lagrangian->energy (L-bob 1 9.8)))
    (define (spin state) (ref (cross-product (coordinate state) (velocity state)) 2))
    (for ([f (list (lambda (state) (sqrt (square (coordinate state)))) energy spin)])
      (check-= (f (swing 20.)) (f (swing 0.)) 1e-8)))
  (test-case "with the angular velocity of the circle it stays at its height"
    (define round (swing-from 1. (sqrt (/ 9.8 (cos 1.)))))
    (check-= (ref (coordinate (round 20.)) 2) (- (cos 1.)) 1e-7))
  (test-case "the picture stays between two circles"
    (define distances (map square (car (frame-curves picture))))
    (check-= (sqrt (apply max distances)) (sin 1.) 1e-3)
    (check-true (> (apply min distances) 0.1))))
