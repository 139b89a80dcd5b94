#lang mechanics
;; A planet under an attraction that falls off as a power of the distance. With the square, Kepler's
;; case, its orbit is closed, whatever its speed; with any other power near it the ellipse turns.

(require mechanics/plot)
(provide interaction)

(define ((rates power) (up t (up x y) (up vx vy)))
  (define r (sqrt (+ (square x) (square y))))
  (define factor (- (expt r (- (+ power 1)))))
  (up 1 (up vx vy) (up (* factor x) (* factor y))))

(define (orbit speed power)
  (evolve-trajectory (rates power) (up 0. (up 1. 0.) (up 0. speed)) 30.))

(define interaction
  (interact ([speed 0.5 1.3 #:start 1.2] [power 1.5 2.2 #:start 2.0])
    (define f (frame -4 2 -3 3 #:x-label "x" #:y-label "y" #:aspect-ratio 'equal))
    (plot-trajectory f (orbit speed power) (component 1 0) (component 1 1))
    (plot-point f 0 0 #:color 'red #:size 12)
    f))
interaction

(module+ test
  (require rackunit)
  (define (after-a-turn speed power)
    (define a (/ 1 (- 2 (square speed))))               ; of Kepler's ellipse
    (define s ((orbit speed power) (* :2pi (expt a 3/2))))
    (+ (square (- (ref s 1 0) 1)) (square (ref s 1 1))))
  (test-case "after a period it is where it was, for the square of the distance alone"
    (for ([speed '(0.8 1. 1.2)]) (check-= (after-a-turn speed 2.) 0 1e-9))
    (check-true (> (after-a-turn 1.2 1.9) 0.01))))
