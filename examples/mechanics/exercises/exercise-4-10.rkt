#lang mechanics
;; Exercise 4.10 (SICM 4.8): invariant curves of the standard map
;; Checked: the golden curve at K = 0.95, and that there is none at K = 1.1
;; How: by the order of points and by Fourier series; bounds of orbits beyond

(require mechanics/book)

(define golden (- 1 (/ 1 golden-ratio)))

;; Its ordinate at θ = 0, by the order of points along the circle ...
(define by-order (find-invariant-curve (standard-map 0.95) golden 0 2.0 2.2 1e-10))
;; ... and by Newton's method for its Fourier series, to rounding.
(define circle (invariant-circle (standard-map 0.95) golden))
(define by-series (invariant-circle-ordinate circle 0))
(list by-order by-series)

;; An attempt at what an invariant curve is: the map moves its points by one and the same angle of
;; the series.  The slip takes the golden ratio's other side.
(define (missed angle turn)
  (define p (circle angle))
  (define image ((standard-map 0.95) (ref p 0) (ref p 1) up void))
  (define q (circle (+ angle (* :2pi turn))))
  (abs ((principal-value :pi) (- (ref image 0) (ref q 0)))))
(list (missed 1. golden) (missed 1. (- 1 golden)))

;; Beyond the critical K = 0.9716 the series does not converge, and which-way? still answers; but
;; an orbit passes where the curve was.
(define beyond
  (with-handlers ([exn:fail:mechanics:not-convergent? (lambda (e) 'none)])
    (invariant-circle (standard-map 1.1) golden #:most-modes 256)))
beyond
(define (range-of-action K n)
  (define lifted (lambda (theta I) (+ I (* K (sin theta)))))
  (for/fold ([theta 0.1] [I 0.1] [least 0.1] [most 0.1] #:result (- most least)) ([k n])
    (define next (lifted theta I))
    (values (+ theta next) next (min least next) (max most next))))
(define confined (range-of-action 0.95 100000))
(define wanders (range-of-action 1.4 100000))
(list (< confined :2pi) (> wanders :2pi))

(module+ test
  (require rackunit)
  (test-case "the golden curve"
    (check-= by-order 2.1144605494391726 1e-9)
    (check-= by-series 2.1144605494391726 1e-11)
    (check-true (< (missed 1. golden) 1e-12))
    (check-true (> (missed 1. (- 1 golden)) 0.1)))
  (test-case "beyond the critical K there is none"
    (check-equal? beyond 'none)
    (check-true (< confined :2pi))
    (check-true (> wanders :2pi))))
