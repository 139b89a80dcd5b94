#lang racket/base
;; Hodge's star, and the operators of vector calculus, in any coordinates and dimension.
;;
;; The volume form of a metric g and a basis is √|det g(eᵢ, eⱼ)| ẽ⁰ ∧ ẽ¹ ∧ …, so that the basis
;; has the right-handed order.  With it,
;;
;;     (⋆ω)(v₁ …) = 1/k! Σ ω(with raised indices) vol(those, v₁ …),
;;
;; and ω ∧ ⋆ω = g(ω, ω) vol.  A divergence needs no volume: div v = ∂ᵢvⁱ + Γᵏ_ki vⁱ.

(require "basis.rkt" "chart-calculus.rkt" "component-array.rkt" "connection.rkt"
         "covariant-derivative.rkt" "exterior-calculus.rkt" "tensor-field.rkt" "manifold-chart.rkt"
         "manifold-function.rkt" "metric.rkt" "raising-and-lowering.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt"
         "../generic/up-down.rkt" "../generic/wrong-argument.rkt")

(provide Hodge-star volume-form codifferential
         metric-gradient curl divergence Laplacian)

;; ---------------------------------------------------------------------------

(define (volume-form metric basis)
  (define g (as-metric 'volume-form metric basis))
  (define es (vector->list (tuple-elements (basis-of-vectors basis))))
  (define n (length es))
  (define size                            ; √|det g(eᵢ, eⱼ)|
    (make-manifold-function
     #f
     (lambda (C)
       (define G (for*/vector ([u (in-list es)] [v (in-list es)]) (expression-in (g u v) C)))
       (root-of-size (determinant-of-matrix G n) C))
     (lambda () `(volume ,(value->datum g) ,(value->datum basis)))))
  (g:* size (apply wedge (vector->list (tuple-elements (basis-of-forms basis))))))

;; ((Hodge-star g basis) w), of a form or a function
(define (Hodge-star g basis)
  (define volume (volume-form g basis))
  (define n (basis->dimension basis))
  (lambda (w)
    (cond [(function-of-points? w) (g:* w volume)]
          [(form-field? w) (star-of w g volume n)]
          [else (complain-of-argument 'Hodge-star "a form, or a function on the manifold" w)])))

(define (star-of w g volume n)
  (define k (field-rank w))
  (define over (field-over w))
  (define home (common-field-home 'Hodge-star (list w volume)))
  (define inverse-metric (metric:invert g))
  (define (find C)
    (define inverse (components-over inverse-metric over C))
    (define raised
      (for/fold ([T (components-in w C)]) ([p (in-range k)])
        (apply-to-index T n k p (lambda (j i) (component inverse n (list j i))))))
    (define vol (components-over volume over C))
    (define size (expt n (- n k)))
    (for/vector #:length size ([place (in-range size)])
      (define sum
        (sum-of-products (vector-length raised) (lambda (i) (vector-ref raised i))
                         (lambda (i) (vector-ref vol (+ (* i size) place)))))
      (if (eqv? sum 0) 0 (g:/ sum (for/product ([i (in-range 1 (add1 k))]) i)))))
  (define (make-datum) `((Hodge-star ,(value->datum g)) ,(value->datum w)))
  (if (= k n)
      (make-manifold-function home (lambda (C) (vector-ref (find C) 0)) make-datum)
      (make-field home (vectors (- n k)) find make-datum #:over over #:form? #t)))

;; (δω)(v …) = −Σ gⁱʲ (∇ᵢ ω)(∂ⱼ, v …), which takes forms to those of a rank less
(define (codifferential metric basis)
  (define g (as-metric 'codifferential metric basis))
  (define c (metric->Cartan g basis))
  (lambda (w)
    (cond [(function-of-points? w) 0]
          [(form-field? w) (check-on-manifold 'codifferential w) (codifferential-of w g c)]
          [else (complain-of-argument 'codifferential "a form" w)])))

(define (codifferential-of w g c)
  (define k (field-rank w))
  (define home (common-field-home 'codifferential (list w g)))
  (define d (covariant-derivative c))
  (define (find C)
    (define n (coordinate-system-dimension C))
    (define inverse (inverse-metric-components g C))
    (define es (tuple-elements (coordinate-system->vector-basis C)))
    (define slopes (for/vector ([e (in-vector es)]) (components-in ((d e) w) C)))
    (define size (expt n (sub1 k)))
    (for/vector #:length size ([place (in-range size)])
      (g:- (sum-of-products
            (* n n) (lambda (ij) (vector-ref inverse ij))
            (lambda (ij)
              (vector-ref (vector-ref slopes (quotient ij n))
                          (+ (* (remainder ij n) size) place)))))))
  (define (make-datum) `((codifferential ,(value->datum g)) ,(value->datum w)))
  (if (= k 1)
      (make-manifold-function home (lambda (C) (vector-ref (find C) 0)) make-datum)
      (make-field home (vectors (sub1 k)) find make-datum #:form? #t)))

;; ---------------------------------------------------------------------------
;; Gradient, curl, divergence, Laplacian

(define (metric-gradient g basis)
  (define up-again (raise-form g basis))
  (lambda (f)
    (check-argument 'gradient function-of-points? f "a function on the manifold")
    (up-again (exterior-derivative f))))

;; In three dimensions
(define (curl g basis)
  (define star (Hodge-star g basis))
  (unless (= (basis->dimension basis) 3)
    (complain 'curl "the curl is a vector field in 3 dimensions only; this basis has ~a"
              (basis->dimension basis)))
  (lambda (v)
    (check-argument 'curl vector-field? v "a vector field")
    ((raise-form g basis) (star (exterior-derivative ((lower g) v))))))

(define (divergence g basis)
  (define c (metric->Cartan g basis))
  (lambda (v)
    (check-argument 'divergence vector-field? v "a vector field")
    (check-on-manifold 'divergence v)
    (make-manifold-function (common-field-home 'divergence (list v g))
                            (lambda (C) (divergence-in v c C))
                            (lambda () `((divergence ,(value->datum g)) ,(value->datum v))))))

(define (divergence-in v c C)
  (define n (coordinate-system-dimension C))
  (define vs (components-in v C))
  (define slopes (derivatives-by-coordinates vs C))
  (define Gamma (connection-coefficients c C))
  (g:+ (sum-over n (lambda (i) (vector-ref (vector-ref slopes i) i)))
       (sum-of-products n (lambda (i) (vector-ref vs i))
                        (lambda (i)
                          (sum-over n (lambda (k) (component Gamma n (list k i k))))))))

(define (Laplacian g basis)
  (define grad (metric-gradient g basis))
  (define div (divergence g basis))
  (lambda (f) (div (grad f))))
