#lang mechanics
;; Paths of the angular momentum on the principal axes  (SICM 2.8.2, Figure 2.3)
;;
;; All motions have one energy: the paths lie on an ellipsoid, which is seen from a corner, the
;; side in the back dotted.  They close around the axes of the greatest and the least moment; the
;; separatrix, in red, goes from one end of the middle axis to the other.

(require mechanics/plot)

(define-values (A B C) (values 1. (sqrt 2.) 2.))
(define E 1/2)
(define semiaxes (map (lambda (moment) (sqrt (* 2 E moment))) (list A B C)))

;; The view: to the right, up, and towards the eye.
(define-values (right above eye)
  (values (up -0.6 0.8 0) (up -0.48 -0.36 0.8) (up 0.64 0.48 0.6)))
(define (front? L)
  (positive? (for/sum ([x (structure->list L)] [n (structure->list eye)] [s semiaxes])
               (/ (* x n) (square s)))))

;; ω on the body with this part of the energy about the first axis, the rest about the third
(define (start share axis other)
  (define (rate moment part) (sqrt (/ (* 2 E part) moment)))
  (define moments (list A B C))
  (list->up (for/list ([i 3])
              (cond [(= i axis) (rate (list-ref moments i) share)]
                    [(= i other) (rate (list-ref moments i) (- 1 share))]
                    [else 0.]))))

(define (path omega duration)
  (define motion
    (evolve-trajectory (qw-sysder A B C) (up 0 (up 1 0 0 0) omega) duration #:tolerance 1e-11))
  (for/list ([t (in-range 0. duration 0.05)]) ((L-body A B C) (velocity (motion t)))))

(define picture (frame -1.5 1.5 -1.5 1.5 #:width 450 #:height 450))
(define (show L color)
  (define thin? (not (front? L)))
  (plot-point picture (dot-product L right) (dot-product L above)
              #:color color #:size (if thin? 0.5 1.5)))
;; With a path its mirror images: on the other side of the axis, and turned backwards.
(define (draw omega duration [color 0])
  (for ([L (path omega duration)])
    (for* ([m '(1 -1)] [n '(1 -1)])
      (show (up (* m (ref L 0)) (* n (ref L 1)) (* m (ref L 2))) color))))

(for* ([share '(0.1 0.3 0.6 0.9)] [axis '(0 2)]) (draw (start share axis 1) 30.))

;; Where both constants are those of the middle axis, L² = 2 E B
(define crossing (start (/ (- C B) (- C A)) 0 2))
(draw crossing 40. 'red)
(draw (up (ref crossing 0) 0. (- (ref crossing 2))) 40. 'red)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-2-3.png"))

(module+ test
  (require rackunit)
  (define ends (for/list ([L (path crossing 40.)]) (ref L 1)))
  (test-case "the separatrix has the constants of the middle axis, and goes to its end"
    (define L0 ((L-body A B C) crossing))
    (check-= (square L0) (* 2 E B) 1e-13)
    (check-= (apply max ends) (list-ref semiaxes 1) 1e-3))
  (test-case "the others close around the axis they start near"
    (for ([axis '(0 2)])
      (define parts (for/list ([L (path (start 0.85 axis 1) 30.)]) (ref L axis)))
      (check-true (positive? (apply min parts)))))
  (test-case "all are on the ellipsoid of the energy"
    (for ([L (path (start 0.7 0 1) 10.)])
      (check-= (for/sum ([x (structure->list L)] [s semiaxes]) (square (/ x s))) 1 1e-9))))
