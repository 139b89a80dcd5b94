#lang racket/base
;; Lie derivatives: how fields change along the flow of a vector field.
;;
;; In a chart, with a term for each argument of T,
;;
;;     (£_X T)(… ∂ᵢ …) = Xᵏ ∂ₖ T(…) + Σ ∂ᵢXᵏ T(… ∂ₖ …),   (£_X T)(… dxⁱ …) = … − Σ ∂ₖXⁱ T(… dxᵏ …).
;;
;; That of a vector field is the bracket, [X, Y] = X Y − Y X as operators on functions.

(require "basis.rkt" "chart-calculus.rkt" "component-array.rkt" "tensor-field.rkt"
         "manifold-chart.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt"
         "../value/operator.rkt")

(provide Lie-derivative-along Lie-bracket)

;; The operator £_X, on functions and fields.
(define (Lie-derivative-along X)
  (check-argument 'Lie-derivative vector-field? X "a vector field")
  (check-on-manifold 'Lie-derivative X)
  (make-primitive-operator (lambda (T) (change-along X T))
                           (lambda () (list 'Lie-derivative (value->datum X)))))

(define (change-along X T)
  (cond [(tuple? T) (structure-map (lambda (part) (change-along X part)) (adopt T))]
        [(function-of-fields? T) (changed-function (lambda (T) (change-along X T)) T)]
        [(not (field? T)) (X T)]
        [else
         (check-on-manifold 'Lie-derivative T)
         (make-field (common-field-home 'Lie-derivative (list T X)) (field-types T)
                     (lambda (C) (changed-components X T C))
                     (lambda () `((Lie-derivative ,(value->datum X)) ,(value->datum T)))
                     #:form? (field-form? T))]))

(define (changed-components X T C)
  (define n (coordinate-system-dimension C))
  (define Xs (components-in X C))
  (define Ts (components-in T C))
  (define slopes (derivatives-by-coordinates Xs C))             ; [k][i] = ∂ₖXⁱ
  (define (slope k i) (vector-ref (vector-ref slopes k) i))
  (define along (rates-along Xs (derivatives-by-coordinates Ts C)))
  (define rank (field-rank T))
  (for/fold ([sum along]) ([type (in-list (field-types T))] [p (in-naturals)])
    (add-components sum
                    (apply-to-index Ts n rank p
                                    (if (eq? type 'vector)
                                        slope
                                        (lambda (i k) (g:- (slope k i))))))))

(define (Lie-bracket X Y)
  (check-argument 'commutator vector-field? X "a vector field")
  (check-argument 'commutator vector-field? Y "a vector field")
  (check-on-manifold 'commutator X)
  (check-on-manifold 'commutator Y)
  (make-field (common-field-home 'commutator (list X Y)) '(1form)
              (lambda (C) (changed-components X Y C))
              (lambda () (list 'commutator (value->datum X) (value->datum Y)))))
