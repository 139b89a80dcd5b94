#lang racket/base
;; Maps between manifolds, and their action on functions, vectors and forms.
;;
;; A map μ from M to N is a procedure from points to points.  Forms are pulled back; a vector field
;; is pushed to one over the map, and to a field on N where μ has an inverse.

(require "component-array.rkt" "tensor-field.rkt" "basis.rkt"
         "manifold-chart.rkt"
         "manifold-function.rkt" "manifold-point.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         "../value/compose.rkt")

(provide differential
         pullback pullback-function pullback-form pullback-vector-field
         pushforward-function pushforward-vector
         vector-field->vector-field-over-map form-field->form-field-over-map basis->basis-over-map
         literal-manifold-map)

(define (check-map who map)
  (check-argument who (lambda (f) (and (procedure? f) (not (field? f)) (accepts? f 1))) map
                  "a map between manifolds, a function from points to points"))

(define (call-of name map x) (lambda () `((,name ,(value->datum map)) ,(value->datum x))))

;; (literal-manifold-map 'mu R1-rect S2-spherical): an unknown map, by coordinates
(define (literal-manifold-map name from to)
  (define who 'literal-manifold-map)
  (check-argument who symbol? name "a quoted name, such as 'mu")
  (check-coordinate-system who from)
  (check-coordinate-system who to)
  (define parts
    (for/vector ([i (in-range (coordinate-system-dimension to))])
      (literal-of-coordinates (string->symbol (format "~a^~a" name i)) from)))
  (make-function (lambda (m)
                   (define x ((chart from) m))
                   ((point to) (coordinate-tuple (for/vector ([f (in-vector parts)]) (f x)))))
                 2 (lambda () name)))

;; ---------------------------------------------------------------------------
;; Over a map

;; The image of a vector field on M: a field over μ, which differentiates functions on N along it.
(define ((differential map) v)
  (check-map 'differential map)
  (check-argument 'differential vector-field? v "a vector field")
  (check-on-manifold 'differential v)
  (make-field (field-home v) '(1form)
              (lambda (C)
                (rates-along (components-in v C) (place-slopes (place-over map C) C)))
              (call-of 'differential map v)
              #:over map))

;; T at the points of the map
(define (over-map who T map)
  (check-map who map)
  (check-argument who (lambda (T) (and (field? T) (not (field-over T)))) T
                  "a field on a manifold")
  (make-field #f (field-types T)
              (lambda (C) (components-over T map C))
              (call-of who map T)
              #:over map #:form? (field-form? T)))

(define ((vector-field->vector-field-over-map map) v)
  (over-map 'vector-field->vector-field-over-map v map))
(define ((form-field->form-field-over-map map) w)
  (over-map 'form-field->form-field-over-map w map))

(define (basis->basis-over-map map b)
  (check-basis 'basis->basis-over-map b)
  (define (along T) (over-map 'basis->basis-over-map T map))
  (make-basis (structure-map along (basis-of-vectors b)) (structure-map along (basis-of-forms b))))

;; ---------------------------------------------------------------------------
;; Back to M

(define ((pullback-function map) f)
  (check-map 'pullback map)
  (define (there C)
    (define p (place-over map C))
    (evaluate-structure (expression-in f (place-system p)) (place-system p) (place-coordinates p)))
  (make-manifold-function #f there (call-of 'pullback map f)))

;; (μ*ω)(v …) = ω(dμ v …), of a form or a metric
(define ((pullback-form map) w)
  (check-map 'pullback map)
  (check-argument 'pullback of-vectors? w "a form, or another tensor of vectors, as a metric is")
  (unless (eq? (field-over w) map) (check-on-manifold 'pullback w))
  (make-field #f (field-types w)
              (lambda (C)
                (define p (place-over map C))
                (pulled-back (components-over w map C) (field-rank w) (place-slopes p C)
                             (target-dimension p) (coordinate-system-dimension C)))
              (call-of 'pullback map w)
              #:form? (field-form? w)))

(define (of-vectors? w) (and (field? w) (andmap (lambda (t) (eq? t 'vector)) (field-types w))))

;; slopes : [k][i] = ∂xᵢ/∂cₖ; from n dimensions to m
(define (pulled-back Ts rank slopes n m)
  (build-components
   m rank
   (lambda (ks)
     (vector-ref (contract-all Ts n (for/list ([k (in-list ks)]) (vector-ref slopes k))) 0))))

;; By the inverse map, which a vector field needs.
(define ((pullback-vector-field map inverse) v) ((pushforward-vector inverse map) v))

(define (pullback map [inverse #f])
  (lambda (x)
    (cond [(vector-field? x)
           (unless inverse
             (complain 'pullback "a vector field is pulled back along a map that has an inverse~a"
                       ": ((pullback map inverse) v)"))
           ((pullback-vector-field map inverse) x)]
          [(field? x) ((pullback-form map) x)]
          [else ((pullback-function map) x)])))

;; ---------------------------------------------------------------------------
;; On to N, where the map has an inverse

(define ((pushforward-function inverse) f) ((pullback-function inverse) f))

;; The field on N that takes f to (v(f ∘ μ)) ∘ μ⁻¹
(define ((pushforward-vector map inverse) v)
  (check-map 'pushforward-vector map)
  (check-map 'pushforward-vector inverse)
  (check-argument 'pushforward-vector vector-field? v "a vector field")
  (procedure->vector-field
   (lambda (f) ((pullback-function inverse) (v ((pullback-function map) f))))
   ((call-of 'pushforward-vector map v))))
