#lang mechanics
;; Exercise 4.9 (SICM 4.8): a chain of six secondary islands
;; Checked: six stable points of period 6 and six unstable ones, in turn around the centre
;; How: find-fixed-point of the driven pendulum's strobe map, where a rotation number is 1/6

(require mechanics/book)

;; The pendulum of Figure 4.3: A = 0.001 m, ω = 4.2 ω₀.
(define T (driven-pendulum-map 1. 1. 9.8 0.001 (* 4.2 (sqrt 9.8))))
(define center (find-fixed-point T (up 0 0)))
(fixed-point-kind center)

;; Turns around the centre in each period fall outwards, through 1/6.
(define (turns theta)
  (abs (rotation-value (rotation-number T (up theta 0.) 300 #:about (up 0 0)))))
(map turns '(0.3 1.2 2.4))

;; One point of period 6 lies on the axis, between two islands; and one is the middle of one.
(define unstable (find-fixed-point T (up 2.2 0.) #:period 6))
(define stable (find-fixed-point T (up 0. 5.58) #:period 6))
(define (orbit point)
  (for/fold ([all '()] [p (fixed-point-coordinates point)] #:result (reverse all)) ([k 6])
    (values (cons p all) (T (ref p 0) (ref p 1) up void))))
(fixed-point-kind stable)
(apply values (fixed-point-multipliers stable))
(fixed-point-kind unstable)
(apply values (fixed-point-multipliers unstable))

;; Around the centre the kinds take turns, as Poincaré and Birkhoff say.
(define (angle p) (atan (ref p 1) (* 5 (ref p 0))))
(define kinds
  (map cadr
       (sort (append (for/list ([p (orbit stable)]) (list (angle p) 'stable))
                     (for/list ([p (orbit unstable)]) (list (angle p) 'unstable)))
             < #:key car)))
kinds

;; An attempt: areas are kept, so the multipliers of each have the product 1; a slip: they lie
;; on the unit circle, which holds of the stable ones alone.
(define (product p) (apply * (fixed-point-multipliers p)))
(define (sizes p) (map magnitude (fixed-point-multipliers p)))

(module+ test
  (require rackunit)
  (test-case "the rotation number passes 1/6"
    (check-true (> (turns 0.3) 1/6 (turns 2.4))))
  (test-case "six stable and six unstable points, in turn"
    (check-equal? (fixed-point-kind stable) 'elliptic)
    (check-equal? (fixed-point-kind unstable) 'hyperbolic)
    (check-equal? (length kinds) 12)
    (for ([a kinds] [b (cdr kinds)]) (check-not-equal? a b)))
  (test-case "multipliers"
    (for ([p (list stable unstable)]) (check-= (product p) 1 1e-8))
    (for ([size (sizes stable)]) (check-= size 1 1e-8))
    (check-true (> (car (sizes unstable)) 1.01))))
