#lang racket/base
;; Points of manifolds, and their coordinates in any chart.
;;
;; A point remembers the chart and the coordinates that it was given by: in that chart it has
;; them as they are, in another those of its place.
;;
;; A tuple may be marked as coordinates in one chart: then no other chart takes it.

(require "manifold-chart.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/scalar.rkt"
         "../generic/printed-function.rkt" "../generic/up-down.rkt" "../generic/value-struct.rkt"
         "../value/shape.rkt")

(provide point chart point? point-system point-coordinates
         mark-coordinates chart-of-coordinates
         generic-point coordinates-in check-point check-coordinates
         typical-coords typical-point)

;; coordinates : a tuple, or a number if there is one
(value-struct manifold-point (system coordinates)
  #:datum (lambda (m)
            `((point ,(value->datum (manifold-point-system m)))
              ,(value->datum (manifold-point-coordinates m))))
  #:word "a point of a manifold")

(define (point? x) (manifold-point? x))
(define (point-system m) (manifold-point-system m))
(define (point-coordinates m) (manifold-point-coordinates m))

;; ((point R2-polar) (up r theta))
(define (point C)
  (check-coordinate-system 'point C)
  (unary-function (call-datum 'point C) (x)
    (check-coordinates C x)
    (manifold-point C (in-signs-of-chart C (if (vector? x) (vector->up x) x)))))

;; The coordinates that the chart has for the place, where x has the sign of another: an angle that
;; was followed through a pole is told by the other meridian.
(define (in-signs-of-chart C x)
  (define (wrong? p) (and (real? p) (< p 0)))
  (if (ormap wrong? (coordinate-system-positive C x))
      (place->coordinates C (coordinates->place C x))
      x))

(define (check-coordinates C x)
  (define n (coordinate-system-dimension C))
  (unless (if (= n 1) (scalar? x) (and (up? x) (= n (length (scalars x)))))
    (complain 'point "a point of ~a has ~a\n  given: ~a" (value->text C)
              (if (= n 1) "one coordinate, a number" (format "an up tuple of ~a coordinates" n))
              (describe-with-value x)))
  (define own (chart-of-coordinates x))
  (unless (or (not own) (same-chart? own C))
    (complain 'point "these coordinates are in ~a, not in ~a\n  given: ~a" (value->text own)
              (value->text C) (describe-with-value x))))

;; up tuple -> the chart that it is marked for
(define charts-of-tuples (make-weak-hasheq))

(define (mark-coordinates C x)
  (define marked (up-of (tuple-elements x)))
  (hash-set! charts-of-tuples marked C)
  marked)

(define (chart-of-coordinates x) (hash-ref charts-of-tuples x #f))

;; ((chart R2-rect) m)
(define (chart C)
  (check-coordinate-system 'chart C)
  (unary-function (call-datum 'chart C) (m)
    (check-point m (coordinate-system-manifold C))
    (coordinates-in C m)))

(define (coordinates-in C m)
  (define A (manifold-point-system m))
  (define x (manifold-point-coordinates m))
  (if (same-chart? A C) x (coordinates-elsewhere C A x m)))

(define (coordinates-elsewhere C A x m)
  (define there
    (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (e) #f)])
      (place->coordinates C (coordinates->place A x))))
  (unless (and there (andmap possible? (scalars there)))
    (complain 'chart "the point is outside the chart ~a\n  point: ~a" (value->text C)
              (value->text m)))
  there)

;; Not a number that is no coordinate: infinite, or not real
(define (possible? x) (or (not (number? x)) (and (real? x) (< -inf.0 x +inf.0))))

(define (check-point m manifold)
  (unless (manifold-point? m)
    (complain 'point "expected a point of ~a\n  given: ~a\n  ~a" (value->text manifold)
              (describe-with-value m)
              "a point is made of coordinates in a chart: ((point R2-rect) (up 1 2))"))
  (define own (coordinate-system-manifold (manifold-point-system m)))
  (unless (eq? own manifold)
    (complain 'point "expected a point of ~a; this one is of ~a\n  given: ~a"
              (value->text manifold) (value->text own) (value->text m))))

;; The point of C whose coordinates are the symbols that stand for them.
(define (generic-point C)
  (manifold-point C (coordinate-tuple (coordinate-system-symbols C))))

;; Coordinates, and a point, of names that stand in no expression.
(define (typical-coords C)
  (check-coordinate-system 'typical-coords C)
  (unknowns-like (coordinate-tuple (coordinate-system-symbols C))))

(define (typical-point C) (manifold-point C (typical-coords C)))
