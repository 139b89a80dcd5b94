#lang racket/base
;; Connections: how to compare tensors at neighbouring points.
;;
;; A connection is told by 1-forms ωⁱⱼ and a basis, ∇_v eⱼ = Σᵢ ωⁱⱼ(v) eᵢ (Cartan), or by their
;; components, Christoffel's symbols Γⁱⱼₖ = ωⁱⱼ(eₖ).  Whatever it was told by, in a chart it has
;; coefficients Γᵃ_bk with ∇_∂ₖ ∂_b = Σ Γᵃ_bk ∂ₐ: where ∂_b = Σ ẽʲ_b eⱼ,
;;
;;     Γᵃ_bk = Σᵢ eᵢᵃ (∂ₖ ẽⁱ_b + Σⱼ ωⁱⱼ(∂ₖ) ẽʲ_b).

(require "basis.rkt" "chart-calculus.rkt" "component-array.rkt" "tensor-field.rkt"
         "manifold-chart.rkt"
         "manifold-function.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/up-down.rkt"
         "../generic/printed-function.rkt" "../generic/value-struct.rkt"
         "../generic/wrong-argument.rkt")

(provide make-Cartan Cartan? Cartan->forms Cartan->basis check-Cartan connection-coefficients
         make-connection
         make-Christoffel Christoffel? Christoffel->symbols Christoffel->basis
         Christoffel->Cartan Cartan->Christoffel Cartan-transform symmetrize-Cartan
         symmetrize-Christoffel
         literal-Christoffel-1 literal-Christoffel-2 literal-Cartan)

;; forms : down tuple (by j) of up tuples (by i) of the ωⁱⱼ
;; coefficients : coordinate system -> Γᵃ_bk as components of the indices a, b, k
(value-struct Cartan (forms basis coefficients make-datum)
  #:datum (lambda (c) ((Cartan-make-datum c))))

;; symbols : down tuple (by k) of down tuples (by j) of up tuples (by i) of Γⁱⱼₖ
(value-struct Christoffel (symbols basis)
  #:datum (lambda (c)
            (list 'make-Christoffel (value->datum (Christoffel-symbols c))
                  (value->datum (Christoffel-basis c)))))

(define (check-Cartan who x)
  (check-argument who Cartan? x "a connection, such as (Christoffel->Cartan Christoffel)"))
(define (check-Christoffel who x)
  (check-argument who Christoffel? x "Christoffel symbols, such as metric->Christoffel-2 gives"))

(define (Cartan->forms c) (check-Cartan 'Cartan->forms c) (Cartan-forms c))
(define (Cartan->basis c) (check-Cartan 'Cartan->basis c) (Cartan-basis c))
(define (Christoffel->symbols c)
  (check-Christoffel 'Christoffel->symbols c)
  (Christoffel-symbols c))
(define (Christoffel->basis c) (check-Christoffel 'Christoffel->basis c) (Christoffel-basis c))

(define (connection-coefficients c C) ((Cartan-coefficients c) C))

;; ---------------------------------------------------------------------------
;; From forms

(define (make-Cartan forms basis)
  (define n (check-parts 'make-Cartan forms basis 2 "1-forms: a down tuple of up tuples"))
  (define fields (structure-map (lambda (column) (structure-map form-field column)) forms))
  (Cartan fields basis (once-a-chart (lambda (C) (coefficients-of fields basis n C)))
          (call-datum 'make-Cartan forms basis)))

;; A 1-form, a procedure that is one, or 0
(define (form-field w)
  (cond [(field? w) w]
        [(procedure? w) (procedure->1form-field w)]
        [(eqv? w 0) (procedure->1form-field (lambda (v) 0) 0)]
        [else (complain 'make-Cartan "expected 1-forms\n  given among them: ~a"
                        (describe-with-value w))]))

(define (check-parts who parts basis depth expected)
  (check-basis who basis)
  (define n (basis->dimension basis))
  (unless (let fits? ([x parts] [depth depth])
            (or (= depth 0)
                (and (tuple? x) (= (structure-length (adopt x)) n)
                     (for/and ([e (in-vector (tuple-elements x))]) (fits? e (sub1 depth))))))
    (complain who "expected for ~a basis vectors ~a\n  given: ~a" n expected
              (describe-with-value parts)))
  n)

(define (part s . indices)
  (for/fold ([s s]) ([i (in-list indices)]) (vector-ref (tuple-elements s) i)))

(define (coefficients-of forms basis n C)
  (define (components-of tuple) (structure-elements (structure-map (lambda (T) (components-in T C))
                                                                   tuple)))
  (define e (components-of (basis-of-vectors basis)))            ; [i][a]
  (define dual (components-of (basis-of-forms basis)))           ; [i][b]
  (define slopes (for/vector ([w (in-vector dual)]) (derivatives-by-coordinates w C)))  ; [i][k][b]
  (define omega                                                  ; [j][i][k]
    (for/vector ([j (in-range n)])
      (for/vector ([i (in-range n)])
        (components-in (part forms j i) C))))
  (define (at v . is) (for/fold ([v v]) ([i (in-list is)]) (vector-ref v i)))
  (define (inner i b k)
    (g:+ (at slopes i k b)
         (sum-of-products n (lambda (j) (at dual j b)) (lambda (j) (at omega j i k)))))
  (build-components
   n 3
   (lambda (abk)
     (define-values (a b k) (apply values abk))
     (tidied (sum-of-products n (lambda (i) (at e i a)) (lambda (i) (inner i b k)))))))

;; ---------------------------------------------------------------------------
;; From coefficients in charts, of which the forms are made

;; find : coordinate system -> coefficients;  basis : the one that the forms refer to
(define (make-connection find basis make-datum)
  (define coefficients (once-a-chart find))
  (define n (basis->dimension basis))
  (define forms
    (down-of (for/vector ([j (in-range n)])
               (up-of (for/vector ([i (in-range n)]) (connection-form coefficients basis i j))))))
  (Cartan forms basis coefficients make-datum))

;; ωⁱⱼ(∂ₖ) = Σ ẽⁱₐ (∂ₖ eⱼᵃ + Σ_b Γᵃ_bk eⱼᵇ)
(define (connection-form coefficients basis i j)
  (define e (part (basis-of-vectors basis) j))
  (define w (part (basis-of-forms basis) i))
  (make-field (common-field-home 'Cartan (list e w)) '(vector)
              (lambda (C)
                (define n (coordinate-system-dimension C))
                (define Gamma (coefficients C))
                (define es (components-in e C))
                (define ws (components-in w C))
                (define slopes (derivatives-by-coordinates es C))
                (for/vector ([k (in-range n)])
                  (sum-of-products
                   n (lambda (a) (vector-ref ws a))
                   (lambda (a)
                     (g:+ (vector-ref (vector-ref slopes k) a)
                          (sum-of-products n (lambda (b) (vector-ref es b))
                                           (lambda (b) (component Gamma n (list a b k)))))))))
              (lambda () `(Cartan-form ,i ,j))
              #:form? #t))

;; The same connection, told in another basis.
(define (Cartan-transform c basis)
  (check-Cartan 'Cartan-transform c)
  (check-basis 'Cartan-transform basis)
  (make-connection (Cartan-coefficients c) basis (call-datum 'Cartan-transform c basis)))

;; The connection without torsion that has the same geodesics.
(define (symmetrize-Cartan c)
  (check-Cartan 'symmetrize-Cartan c)
  (make-connection (lambda (C)
                     (define n (coordinate-system-dimension C))
                     (define Gamma (connection-coefficients c C))
                     (build-components
                      n 3 (lambda (abk)
                            (define-values (a b k) (apply values abk))
                            (g:* 1/2 (g:+ (component Gamma n abk)
                                          (component Gamma n (list a k b)))))))
                   (Cartan-basis c)
                   (call-datum 'symmetrize-Cartan c)))

;; ---------------------------------------------------------------------------
;; Christoffel's symbols

(define (make-Christoffel symbols basis)
  (check-parts 'make-Christoffel symbols basis 3
               "symbols, functions: a down tuple of down tuples of up tuples")
  (Christoffel symbols basis))

(define (Christoffel->Cartan c)
  (check-Christoffel 'Christoffel->Cartan c)
  (define basis (Christoffel-basis c))
  (make-Cartan (g:* (Christoffel-symbols c) (basis-of-forms basis)) basis))

(define (Cartan->Christoffel c)
  (check-Cartan 'Cartan->Christoffel c)
  (define basis (Cartan-basis c))
  (Christoffel (structure-map
                (lambda (e)
                  (structure-map (lambda (column) (structure-map (lambda (w) (w e)) column))
                                 (Cartan-forms c)))
                (basis-of-vectors basis))
               basis))

;; Symbols without torsion, in the same basis
(define (symmetrize-Christoffel c)
  (Cartan->Christoffel (symmetrize-Cartan (Christoffel->Cartan c))))

(define (literal-Christoffel-2 name C)
  (literal-symbols 'literal-Christoffel-2 name C up-of "~a^~a_~a~a"))

;; Of the first kind, all indices below
(define (literal-Christoffel-1 name C)
  (literal-symbols 'literal-Christoffel-1 name C down-of "~a_~a~a~a"))

(define (literal-symbols who name C inner pattern)
  (check-argument who symbol? name "a quoted name, such as 'Gamma")
  (check-coordinate-system who C)
  (define n (coordinate-system-dimension C))
  (define (tuple make f) (make (for/vector ([i (in-range n)]) (f i))))
  (Christoffel
   (tuple down-of
          (lambda (k)
            (tuple down-of
                   (lambda (j)
                     (tuple inner
                            (lambda (i)
                              (literal-manifold-function
                               (string->symbol (format pattern name i j k)) C)))))))
   (coordinate-system->basis C)))

(define (literal-Cartan name C) (Christoffel->Cartan (literal-Christoffel-2 name C)))
