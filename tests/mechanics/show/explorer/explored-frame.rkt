#lang racket/base
;; Maps explored in their frame, without a window: what clicks do to it.

(require (only-in mechanics :2pi)
         mechanics/book
         mechanics/plot
         mechanics/show/explorer/explored-frame
         (only-in mechanics/show/plot/frame frame-bounds)
         "../../support/checks.rkt")

(define T (standard-map 0.6))

;; -> a frame with a point, and the map explored in it from the starts
(define (explored map n . starts)
  (define f (frame 0 :2pi 0 :2pi))
  (plot-point f 1 1)
  (define x (open-explored-frame 'explore-map f map n starts))
  (finish x)
  (values f x))

(define (finish x)
  (when (wait-for-points x) (finish x))
  (explored-picture x))

(define (after x action . place)
  (act-on! x action place)
  (finish x))

(define (count f) (length (frame-points f)))

(test-case "orbits from given starts are in the frame, above what was there"
  (define-values (f x) (explored T 10 '(1.0 . 1.0) '(2.0 . 3.0)))
  (check-equal? (count f) 23)
  (check-equal? (explored-text x) "2 orbits, 22 points"))

(test-case "the later an orbit, the later it is drawn"
  (define (stay x y return fail) (return x y))
  (define-values (f x) (explored stay 0 '(3.0 . 1.0) '(2.0 . 3.0)))
  (check-equal? (map vector->list (frame-points f)) '((1.0 1.0) (3.0 1.0) (2.0 3.0))))

(test-case "a click starts an orbit, which grows, is undone, and comes to an end"
  (define-values (f x) (explored T 10))
  (check-eq? (after x "point" 1/2 1/2 1/2 1/2) f)
  (check-equal? (count f) 12)
  (check-equal? (begin (after x "more") (count f)) 22)
  (for ([place '((0 0.5) (1 0.5) (0.5 0) (0.5 1))])
    (apply after x "point" (append place place))
    (check-equal? (count f) 22 "beside the axes"))
  (check-equal? (begin (after x "undo") (count f)) 1)
  (after x "point" 0.6 0.6 0.6 0.6)
  (check-equal? (begin (after x "clear") (count f)) 1)
  (check-equal? (explored-text x) "0 orbits, 0 points"))

(test-case "the place of a click is that of the picture"
  (define (stay x y return fail) (return x y))
  (define-values (f x) (explored stay 0))
  (define zoomed (after x "point" 0.5 0.5 0.7 0.3))
  (define bounds (frame-bounds zoomed))
  (after x "point" 0.5 0.5 0.5 0.5)
  (define middle (vector->list (car (reverse (frame-points f)))))
  (check-true (< (car bounds) (car middle) (cadr bounds)))
  (check-true (< (caddr bounds) (cadr middle) (cadddr bounds))))

(test-case "the bar beside a picture of chaos is no place in the plane"
  (define (points-of bar?)
    (define f (frame 0 :2pi 0 :2pi))
    (chaos-map f T 10 #:samples 4 #:bar? bar?)
    (define x (open-explored-frame 'explore-map f T 10 '()))
    (after x "point" 0.95 0.5 0.95 0.5)
    (count f))
  (check-equal? (map points-of '(#f #t)) '(11 0)))

(test-case "a drag shows a part, with the orbits in it; the frame keeps all"
  (define-values (f x) (explored T 200 '(1.0 . 1.0) '(3.0 . 2.0)))
  (define part (after x "point" 0.5 0.5 0.9 0.1))
  (check-not-eq? part f)
  (check-true (< 0 (count part) (count f)))
  (check-equal? (count f) 403)
  (check-eq? (after x "whole") f))

(test-case "what is drawn later in the frame stays"
  (define-values (f x) (explored T 10))
  (after x "point" 0.5 0.5 0.5 0.5)
  (plot-point f 2 2)
  (after x "clear")
  (check-equal? (count f) 2))

(test-case "an orbit that ends says why"
  (define (once x y return fail) (if (> x 3) (fail) (return (+ x 1) y)))
  (define-values (f x) (explored once 10 '(2.5 . 1.0)))
  (check-equal? (explored-text x) "an orbit ends: no further image")
  (check-equal? (count f) 3))
