#lang racket/base
;; Minima of functions that depend on something being differentiated.
;;
;; Where f(x, a) is least in x, ∂₀f(x, a) = 0: the argument is a root of the gradient, and moves
;; as roots do (implicit-root.rkt), dx = −(∂₀∂₀f)⁻¹ ∂₁∂₀f da.  The least value is f there, and its
;; first derivative is ∂₁f alone.  At an end of an interval the argument moves with the end.
;; At a kink, or where a second derivative vanishes, this says nothing, and we say so.

(require racket/flonum
         "implicit-root.rkt" "minimum.rkt" "objective.rkt"
         "../calculus/derivative.rkt"
         "../error/failure.rkt"
         "../value/shape.rkt")

(provide varying-minimum if-varying varying? raise-kind)

;; Does the value depend on something being differentiated?
(define (varying? y) (not (eqv? 0 (total-order (scalars y)))))

;; make : -> a minimum and the flvector where it is
;; -> this minimum as it varies; #f if it does not vary
(define (if-varying t x make)
  (and (varying? ((objective-tuple-function t) (objective-structure t x)))
       (let-values ([(m x) (make)]) (varying-minimum t m x))))

;; m : a minimum of the target's function, found at the flvector x -> the same with argument
;; and value as they vary
(define (varying-minimum t m x)
  (define f (objective-tuple-function t))
  (define at (objective-structure t x))
  (define who (objective-who t))
  (cond
    [(not (varying? (f at))) m]
    [else
     (unless (minimum-proper? m) (raise-kind who (minimum-kind m) (objective-argument t x)))
     (define (rows) (second-rows who (objective-second-derivatives t x) (flvector-length x) at))
     (define moving
       (varying-root who (lambda (s) (derivative-at f s)) at rows #:what no-inverse))
     (minimum (tuple-like (minimum-argument m) moving) (f moving) (minimum-kind m)
              (minimum-gradient m) (minimum-curvature m) (minimum-evaluations m))]))

(define no-inverse
  "the minimum has no derivative: the second derivatives have no inverse there")

;; second : symmetric
(define (second-rows who second n at)
  (unless second
    (raise-singular who "the minimum has no derivative: the function has no second ones there"
                    at "at" at))
  (columns->rows n second))

(define (raise-kind who kind x)
  (raise-singular
   who
   (string-append "the minimum has no derivative: "
                  (case kind
                    [(kink) "it is at a kink of the function"]
                    [(end) "it is at an end of the interval, where the function is level"]
                    [(flat) "the function is flat around it"]
                    [(saddle) "it is at a saddle"]
                    [else "it is degenerate, a second derivative vanishes there"]))
   x "at" x))
