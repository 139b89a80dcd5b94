#lang racket/base
;; Covariant derivatives, of fields on a manifold and over maps.
;;
;; In a chart, with a term for each argument of T,
;;
;;     (∇_v T)(… ∂_b …) = vᵏ ∂ₖ T(…) − Σ Γᵃ_bk vᵏ T(… ∂ₐ …),
;;     (∇_v T)(… dxᵃ …) = … + Σ Γᵃ_bk vᵏ T(… dxᵇ …).
;;
;; Of a field over a map μ the symbols are those at the points of μ, and vᵏ beside them is the
;; image of v: the derivative along a curve is the case that v = d/dt.

(require "basis.rkt" "chart-calculus.rkt" "component-array.rkt" "connection.rkt" "tensor-field.rkt"
         "manifold-chart.rkt"
         "maps-between-manifolds.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/up-down.rkt"
         "../generic/value-struct.rkt" "../generic/wrong-argument.rkt"
         "../value/operator.rkt")

(provide covariant-derivative covariant-derivative? covariant-derivative->Cartan
         Cartan->Cartan-over-map check-covariant-derivative
         geodesic-equation parallel-transport-equation)

(value-struct nabla (Cartan)
  #:datum (lambda (d) (list 'covariant-derivative (value->datum (nabla-Cartan d))))
  #:property prop:procedure (lambda (d v) (derivative-in-direction (nabla-Cartan d) v)))

(define (covariant-derivative? x) (nabla? x))
(define (covariant-derivative->Cartan d) (nabla-Cartan d))

(define (check-covariant-derivative who d)
  (check-argument who nabla? d "a covariant derivative, such as (covariant-derivative Cartan)"))

;; A field knows the map that it is over: the book gives it again.
(define (covariant-derivative c [map #f])
  (check-Cartan 'covariant-derivative c)
  (nabla c))

(define (Cartan->Cartan-over-map c map)
  (check-Cartan 'Cartan->Cartan-over-map c)
  c)

(define (derivative-in-direction c v)
  (check-argument 'covariant-derivative vector-field? v "a vector field")
  (make-primitive-operator
   (lambda (T) (derivative-of c v T))
   (lambda () `((covariant-derivative ,(value->datum c)) ,(value->datum v)))))

(define (derivative-of c v T)
  (cond [(tuple? T) (structure-map (lambda (part) (derivative-of c v part)) (adopt T))]
        [(function-of-fields? T) (changed-function (lambda (T) (derivative-of c v T)) T)]
        [(not (field? T)) (v T)]
        [else
         (when (and (field-over v) (field-over T))
           (complain 'covariant-derivative
                     "the direction of the derivative of a field over a map is on its source"))
         (define over (or (field-over v) (field-over T)))
         (make-field (if over (field-home (if (field-over v) v T))
                         (common-field-home 'covariant-derivative (list v T)))
                     (field-types T)
                     (lambda (C) (derivative-components c v T over C))
                     (lambda ()
                       `(((covariant-derivative ,(value->datum c)) ,(value->datum v))
                         ,(value->datum T)))
                     #:over over #:form? (field-form? T))]))

(define (derivative-components c v T over C)
  (define p (place-over over C))
  (define n (target-dimension p))
  (define-values (rates direction) (rates-of v T over p C))
  (define Gamma
    (evaluate-components (connection-coefficients c (place-system p)) (place-system p)
                         (place-coordinates p)))
  (define turning                         ; [a, b]: Σ Γᵃ_bk vᵏ
    (build-components n 2 (lambda (ab)
                            (sum-of-products
                             n (lambda (k) (vector-ref direction k))
                             (lambda (k) (component Gamma n (append ab (list k))))))))
  (define Ts (components-over T over C))
  (for/fold ([sum rates]) ([type (in-list (field-types T))] [i (in-naturals)])
    (define (turn a b) (component turning n (list a b)))
    (add-components sum
                    (apply-to-index Ts n (field-rank T) i
                                    (if (eq? type 'vector)
                                        (lambda (b a) (g:- (turn a b)))
                                        turn)))))

;; -> vᵏ ∂ₖT, and the direction in the chart of p
(define (rates-of v T over p C)
  (define vs (components-in v C))
  (define (along slopes) (rates-along vs slopes))
  (define A (place-system p))
  (cond [(field-over v)
         (values (along (derivatives-by-coordinates-at (components-in T A) A (place-coordinates p)))
                 vs)]
        [else
         (values (along (derivatives-by-coordinates (components-in T C) C))
                 (if over (along (place-slopes p C)) vs))]))

;; ---------------------------------------------------------------------------
;; Curves

;; γ ↦ ∇_∂t γ', a vector field over γ that vanishes where γ is a geodesic.
;; source : chart of the line;  target : chart of the manifold, for the book's sake
(define (geodesic-equation source target c)
  (define transport (parallel-transport-equation source target c))
  (lambda (gamma) ((transport gamma) ((differential gamma) (time-direction source)))))

;; γ ↦ (u ↦ ∇_∂t u), for a vector field u over γ: it vanishes where u is carried along parallel.
(define (parallel-transport-equation source target c)
  (check-coordinate-system 'geodesic-equation source)
  (check-coordinate-system 'geodesic-equation target)
  (check-Cartan 'geodesic-equation c)
  (lambda (gamma) (lambda (u) (derivative-of c (time-direction source) u))))

(define (time-direction source)
  (native-field source '(1form) (lambda () (vector 1)) (lambda () 'd/dt)))
