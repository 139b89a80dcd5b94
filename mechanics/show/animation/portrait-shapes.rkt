#lang racket/base
;; The phase portrait beside the mechanism, as shapes in pixels, y up: axes with numbers, the
;; curve, and a place on it for each state.

(require "plane-vector.rkt" "shapes.rkt"
         "../plot/axes/plot-ticks.rkt"
         "../../numeric/finite-number.rkt")

(provide portrait-size make-portrait portrait-shapes portrait-dot)

(define portrait-size 260)       ; pixels, width and height

;; Between the edge and the axes.
(define-values (left right bottom top) (values 52.0 12.0 40.0 14.0))

;; x, y : ranges of the axes; shapes : axes and curve
(struct portrait (x y shapes))
(struct range (low high))

;; points : vectors of two flonums, of the curve
(define (make-portrait points x-label y-label)
  (define fine (filter finite-point? points))
  (define-values (x y) (values (range-of (map at-x fine)) (range-of (map at-y fine))))
  (define places (for/list ([p (in-list fine)]) (place x y p)))
  (define curve (if (> (length places) 1) (polyline places #:color faint #:width 1.5) '()))
  (portrait x y (flat-shapes 'phase-portrait (list (axes x y x-label y-label) curve))))

(define (finite-point? p) (and (finite? (at-x p)) (finite? (at-y p))))

(define (portrait-dot p point)
  (if (finite-point? point)
      (list (disc (place (portrait-x p) (portrait-y p) point) 5.0
                  #:fill (cadr accents) #:color #f))
      '()))

;; -> the range of the numbers with a margin; never an empty interval
(define (range-of xs)
  (define-values (low high)
    (if (null? xs) (values 0.0 0.0) (values (apply min xs) (apply max xs))))
  (define least (* 1e-9 (max 1.0 (abs low) (abs high))))
  (define margin (if (< (- high low) least) (max 0.5 (* 0.1 (abs high))) (* 0.06 (- high low))))
  (range (- low margin) (+ high margin)))

(define (place x y p)
  (vector (along x (at-x p) left (- portrait-size right))
          (along y (at-y p) bottom (- portrait-size top))))

(define (along r x from to)
  (+ from (* (- to from) (/ (- x (range-low r)) (- (range-high r) (range-low r))))))

;; ---------------------------------------------------------------------------
;; Axes

(define (axes x y x-label y-label)
  (define-values (l r b t)
    (values left (- portrait-size right) bottom (- portrait-size top)))
  (list (polyline (list (vector l b) (vector r b) (vector r t) (vector l t))
                  #:closed? #t #:color faint #:width 1)
        (tick-marks x (lambda (n) (vector (along x n l r) b)) (vector 0 -4) 'below)
        (tick-marks y (lambda (n) (vector l (along y n b t))) (vector -4 0) 'left)
        (label (vector (/ (+ l r) 2) 14.0) x-label #:size 14)
        (label (vector (+ l 3.0) (- t 10.0)) y-label #:anchor 'right #:size 14)))

;; For each number of the axis a short line from its place outwards, and the number
(define (tick-marks r place outwards anchor)
  (for/list ([t (in-list (ticks-between (range-low r) (range-high r)))] #:when (tick-label t))
    (define at (place (tick-value t)))
    (list (polyline (list at (add at outwards)) #:color faint #:width 1)
          (label at (tick-label t) #:anchor anchor #:size 11 #:italic? #f))))
