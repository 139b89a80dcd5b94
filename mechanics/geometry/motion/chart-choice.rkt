#lang racket/base
;; The chart that is fit for a place.
;;
;; Near a place where coordinates are singular, some change of them hardly moves the point.  With
;; the metric G that a chart has from the space its places are in, 1/tr G⁻¹ is at most the square of
;; the least speed of a point whose coordinates change by 1 in a unit of time: 0 where the chart is
;; singular, sin²θ/(1 + sin²θ) for the angles on a sphere.

(require "../chart-calculus.rkt" "../component-array.rkt" "../manifold-chart.rkt"
         "../manifold-point.rkt"
         "../metric.rkt" "../tensor-field.rkt"
         "../../error/complain.rkt" "../../error/refusal.rkt"
         "../../generic/arithmetic.rkt"
         "../../numeric/constants.rkt" "../../numeric/finite-number.rkt"
         "../../value/shape.rkt")

(provide chart-fitness coordinates-or-none fittest-chart coordinate-periods check-one-manifold)

;; C -> a function of the coordinates
(define chart-fitness
  (once-a-chart
   (lambda (C)
     (define n (coordinate-system-dimension C))
     (define inverse
       (inverse-of-matrix (components-in (coordinate-system->metric C) C) n void))
     (define trace (sum-over n (lambda (i) (component inverse n (list i i)))))
     (define e (vector (tidied (g:/ 1 trace))))
     (lambda (x) (vector-ref (evaluate-components e C x) 0)))))

;; Of the point m in the chart C, or #f where it has none: where those that the chart gives are of
;; another place, as of the antipode where it covers half of a sphere
(define (coordinates-or-none C m)
  (define x (if-raised refusal? #f ((chart C) m)))
  (and x (numeric? x) (andmap finite? (scalars x))
       (same-place? (place-of m) (coordinates->place C x))
       x))

(define (place-of m) (coordinates->place (point-system m) (point-coordinates m)))

(define (same-place? a b)
  (define (size p) (for/fold ([most 0]) ([x (in-list (scalars-of-place p))]) (max most (abs x))))
  (define scale (+ (size a) (size b)))
  (for/and ([x (in-list (scalars-of-place a))] [y (in-list (scalars-of-place b))])
    (<= (abs (- x y)) (* 1e-6 scale))))

;; -> the chart of the list where the point's fitness is greatest, and that fitness
(define (fittest-chart charts m)
  (for/fold ([best #f] [most 0] #:result (values best most)) ([C (in-list charts)])
    (define w (fitness-at C m))
    (if (> w most) (values C w) (values best most))))

(define (fitness-at C m)
  (define x (coordinates-or-none C m))
  (define w
    (if x (if-raised refusal? 0 ((chart-fitness C) x)) 0))
  (if (and (real? w) (finite? w)) w 0))

(define (check-one-manifold who home C)
  (unless (on-one-manifold? C home)
    (complain-showing who "the charts are of different manifolds" "chart" C "home" home)))

;; For each coordinate, 2π if a turn of it comes back to the same place, else #f.
(define coordinate-periods (once-a-chart (lambda (C) (periods-of C))))

(define (periods-of C)
  (define n (coordinate-system-dimension C))
  (define x (for/list ([k (in-range n)]) (+ 0.4 (/ k 7.0))))
  (define (place xs)
    (scalars-of-place (coordinates->place C (coordinate-tuple (list->vector xs)))))
  (define here (place x))
  (for/vector ([k (in-range n)])
    (define turned (for/list ([a (in-list x)] [i (in-naturals)]) (if (= i k) (+ a (* 2 pi)) a)))
    (and (for/and ([a (in-list here)] [b (in-list (place turned))]) (< (abs (- a b)) 1e-9))
         (* 2 pi))))

(define (scalars-of-place p) (vector->list (flat-place p)))
