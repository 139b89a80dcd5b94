#lang mechanics
;; Exercise 4.8 (SICM 4.6.1): another golden invariant curve of the standard map
;; Checked: the curve of the rotation number 1/(2 + φ) at K = 0.6, and that it stays a curve
;; How: by the order of points and by Fourier series; points of an orbit in a small window

(require mechanics/book)

;; Its continued fraction, 0; 3, 1, 1, 1 ..., ends as that of the golden ratio.
(define rotation (/ 1 (+ 2 golden-ratio)))
(define T (standard-map 0.6))
(define turn (* :2pi rotation))
(define by-order (find-invariant-curve T rotation 0 (- turn 0.3) (+ turn 0.5) 1e-10))
(define circle (invariant-circle T rotation #:from (- turn 0.3) #:to (+ turn 0.5)))
(define by-series (invariant-circle-ordinate circle 0))
(list by-order by-series)

;; An attempt: where it is magnified, points of an orbit lie on a curve without width.
(define n 20000)
(define (orbit-near theta half-width)
  (for/fold ([all '()] [x 0.] [y by-series] #:result all) ([k n])
    (define here (if (< (abs (- x theta)) half-width) (list (up x y)) '()))
    (T x y (lambda (x y) (values (append here all) x y)) void)))
(define window (orbit-near 1. 1e-3))
(define (off p) (abs (- (ref p 1) (invariant-circle-ordinate circle (ref p 0)))))
(define width (apply max (map off window)))
(list (length window) (< width 1e-10))

;; A slip: the same with an action a little beside it.  In the window points then scatter about
;; the curve, or leave it.
(define beside (+ by-series 1e-4))
(define slip
  (for/fold ([most 0] [x 0.] [y beside] #:result most) ([k 2000])
    (define here (if (< (abs (- x 1.)) 1e-2) (off (up x y)) 0))
    (T x y (lambda (x y) (values (max most here) x y)) void)))
slip

(module+ test
  (require rackunit)
  (test-case "both ways to the curve agree"
    (check-= by-order by-series 1e-9)
    (check-= (rotation-value (rotation-number T (up 0. by-series))) rotation 1e-11))
  (test-case "it has no width"
    (check-true (> (length window) 3))
    (check-true (< width 1e-10))
    (check-true (> slip 1e-5))))
