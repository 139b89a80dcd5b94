#lang racket/base
;; Torsion and curvature of a connection.
;;
;; In a chart, with the signs of the book (the curvature of the unit sphere is positive),
;;
;;     Tᵃ_kb  = Γᵃ_bk − Γᵃ_kb
;;     Rᵃ_bkl = ∂ₖ Γᵃ_bl − ∂ₗ Γᵃ_bk + Σ Γᵃ_mk Γᵐ_bl − Σ Γᵃ_ml Γᵐ_bk
;;
;; and Ricci's tensor is R_bl = Σ Rᵃ_bal.

(require "basis.rkt" "chart-calculus.rkt" "component-array.rkt" "connection.rkt"
         "covariant-derivative.rkt" "tensor-field.rkt" "manifold-chart.rkt" "manifold-function.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt")

(provide torsion torsion-vector Riemann Riemann-curvature Ricci)

;; A tensor field of the connection, whose components f makes of its coefficients.
(define (tensor-of who nabla types f)
  (check-covariant-derivative who nabla)
  (define c (covariant-derivative->Cartan nabla))
  (make-field (home-of-connection c) types
              (lambda (C) (f (connection-coefficients c C) (coordinate-system-dimension C) C))
              (lambda () (list who (value->datum nabla)))))

(define (home-of-connection c)
  (apply common-home 'covariant-derivative #:of field-home
         (vector->list (tuple-elements (basis->vector-basis (Cartan->basis c))))))

;; ((torsion nabla) w X Y) and ((torsion-vector nabla) X Y), which w is taken of
(define (torsion nabla)
  (tensor-of 'torsion nabla '(1form vector vector)
             (lambda (Gamma n C)
               (build-components
                n 3 (lambda (akb)
                      (define-values (a k b) (apply values akb))
                      (g:- (component Gamma n (list a b k)) (component Gamma n (list a k b))))))))

(define (torsion-vector nabla)
  (define T (torsion nabla))
  (lambda (X Y) (vector-of 'torsion-vector T (list X Y) `((torsion-vector ,(value->datum nabla))
                                                          ,(value->datum X)
                                                          ,(value->datum Y)))))

;; ((Riemann nabla) w V X Y) = w(((Riemann-curvature nabla) X Y) V)
(define (Riemann nabla)
  (tensor-of 'Riemann nabla '(1form vector vector vector) Riemann-components))

(define (Riemann-components Gamma n C)
  (define slopes (derivatives-by-coordinates Gamma C))
  (define (slope k . is) (component (vector-ref slopes k) n is))
  (define (symbol . is) (component Gamma n is))
  (define (half a b k l)
    (g:+ (slope k a b l)
         (sum-of-products n (lambda (m) (symbol a m k)) (lambda (m) (symbol m b l)))))
  ;; R is antisymmetric in its last two indices.
  (define known
    (build-components n 4 (lambda (abkl)
                            (define-values (a b k l) (apply values abkl))
                            (if (< k l) (tidied (g:- (half a b k l) (half a b l k))) 0))))
  (build-components n 4 (lambda (abkl)
                          (define-values (a b k l) (apply values abkl))
                          (if (> k l)
                              (g:- (component known n (list a b l k)))
                              (component known n abkl)))))

(define (Riemann-curvature nabla)
  (define R (Riemann nabla))
  (lambda (X Y)
    (lambda (V)
      (vector-of 'Riemann-curvature R (list V X Y)
                 `(((Riemann-curvature ,(value->datum nabla)) ,(value->datum X) ,(value->datum Y))
                   ,(value->datum V))))))

;; The vector field whose 1-form is the tensor's first argument, the others given.
(define (vector-of who T vectors datum)
  (for ([v (in-list vectors)]) (check-argument who vector-field? v "a vector field"))
  (define all (cons T vectors))
  (define over (common-over who all))
  (make-field (common-field-home who all) '(1form)
              (lambda (C)
                (define n (target-dimension (place-over over C)))
                (define Ts (components-over T over C))
                (define given (for/list ([v (in-list vectors)]) (components-over v over C)))
                (for/vector #:length n ([a (in-range n)])
                  (vector-ref (contract-all (components-from Ts n a) n given) 0)))
              (lambda () datum)
              #:over over))

;; ((Ricci nabla basis) u v); the contraction is the same in every basis.
(define (Ricci nabla [basis #f])
  (check-covariant-derivative 'Ricci nabla)
  (when basis (check-basis 'Ricci basis))
  (define R (Riemann nabla))
  (make-field (field-home R) '(vector vector)
              (lambda (C) (ricci-components (components-in R C) (coordinate-system-dimension C)))
              (lambda () (list 'Ricci (value->datum nabla)))))

(define (ricci-components R n)
  (build-components n 2 (lambda (bl)
                          (define-values (b l) (apply values bl))
                          (tidied (sum-over n (lambda (a) (component R n (list a b a l))))))))
