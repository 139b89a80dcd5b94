#lang racket/base
;; Forms: products, the exterior derivative, contraction with a vector field.
;;
;; With one sum over the *shuffles* of the arguments, the ways to deal k of them to the first
;; factor and l to the second, each in order,
;;
;;     (α ∧ β)(v₁ … vₖ₊ₗ) = Σ ± α(v …) β(v …),
;;
;; so that (dx ∧ dy)(∂/∂x, ∂/∂y) = 1; and in a chart
;;
;;     (dω)(∂ᵢ₀ … ∂ᵢₖ) = Σₘ (−1)ᵐ ∂ᵢₘ ω(∂ᵢ₀ … without ∂ᵢₘ … ∂ᵢₖ).

(require (only-in racket/list check-duplicates combinations permutations range)
         "chart-calculus.rkt" "component-array.rkt" "tensor-field.rkt" "manifold-chart.rkt"
         "manifold-function.rkt"
         "../algebra/elimination/block-form.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt")

(provide wedge exterior-derivative interior-product Alt vectors)

(define (check-form who w) (check-argument who form-field? w "a form, such as dx"))

;; ---------------------------------------------------------------------------
;; The exterior product; functions are forms of rank 0

(define wedge
  (case-lambda
    [() 1]
    [(w) w]
    [(a b . more) (apply wedge (wedge-of-two a b) more)]))

(define (wedge-of-two a b)
  (cond [(and (field? a) (field? b))
         (check-form 'wedge a)
         (check-form 'wedge b)
         (product-of-forms a b)]
        [(and (function-of-points? a) (or (field? b) (function-of-points? b))) (g:* a b)]
        [(function-of-points? b) (check-form 'wedge a) (g:* b a)]
        [else (check-form 'wedge a) (check-form 'wedge b)]))

(define (product-of-forms a b)
  (define k (field-rank a))
  (define rank (+ k (field-rank b)))
  (define deals (shuffles rank k))
  (define over (common-over 'wedge (list a b)))
  (make-field (common-field-home 'wedge (list a b)) (vectors rank)
              (lambda (C)
                (define n (target-dimension (place-over over C)))
                (define as (components-over a over C))
                (define bs (components-over b over C))
                (antisymmetric n rank
                               (lambda (is) (sum-of-deals n is deals as bs))))
              (lambda () (list 'wedge (value->datum a) (value->datum b)))
              #:over over #:form? #t))

;; The types of the arguments of a form of rank k
(define (vectors k) (for/list ([_ (in-range k)]) 'vector))

;; (sign first-places other-places) for each
(define (shuffles n k)
  (for/list ([first (in-list (combinations (range n) k))])
    (define others (for/list ([i (in-range n)] #:unless (memv i first)) i))
    (list (permutation-sign (append first others)) first others)))

(define (sum-of-deals n is deals as bs)
  (define (pick places) (for/list ([p (in-list places)]) (list-ref is p)))
  (for/fold ([sum 0]) ([d (in-list deals)])
    (define x (component as n (pick (cadr d))))
    (define y (if (eqv? x 0) 0 (component bs n (pick (caddr d)))))
    (if (eqv? y 0) sum (g:+ sum (g:* (car d) x y)))))

;; The components that f gives for ascending indices, and for all others by their order.
(define (antisymmetric n k f)
  (define known (make-hash))
  (build-components
   n k
   (lambda (is)
     (cond [(check-duplicates is) 0]
           [else
            (define sorted (sort is <))
            (define value (hash-ref! known sorted (lambda () (f sorted))))
            (if (eqv? value 0) 0 (g:* (permutation-sign is) value))]))))

;; ---------------------------------------------------------------------------
;; The exterior derivative

(define (exterior-derivative w)
  (cond [(field? w)
         (check-form 'd w)
         (derivative-of-form w)]
        [(function-of-points? w) (differential-of w)]
        [else (complain-of-argument 'd "a function on a manifold, or a form" w)]))

(define (differential-of f)
  (define home (home-of f))
  (make-field home '(vector)
              (lambda (C)
                (define e (expression-in f C))
                (when (tuple? e)
                  (complain 'd "expected a function whose values are numbers\n  given: ~a"
                            (value->text f)))
                (for/vector ([slope (in-vector (derivatives-by-coordinates (vector e) C))])
                  (vector-ref slope 0)))
              (lambda () (list 'd (value->datum f)))
              #:form? #t))

(define (derivative-of-form w)
  (check-on-manifold 'd w)
  (define rank (add1 (field-rank w)))
  (make-field (field-home w) (vectors rank)
              (lambda (C)
                (define n (coordinate-system-dimension C))
                (define slopes (derivatives-by-coordinates (components-in w C) C))
                (antisymmetric n rank (lambda (is) (alternating-slopes slopes n is))))
              (lambda () (list 'd (value->datum w)))
              #:form? #t))

(define (alternating-slopes slopes n is)
  (for/fold ([sum 0]) ([i (in-list is)] [m (in-naturals)])
    (define slope (component (vector-ref slopes i) n (remv i is)))
    (cond [(eqv? slope 0) sum]
          [(even? m) (g:+ sum slope)]
          [else (g:- sum slope)])))

;; ---------------------------------------------------------------------------
;; Contraction, and the antisymmetric part

;; ((interior-product X) ω) = ω(X, …)
(define (interior-product X)
  (check-argument 'interior-product vector-field? X "a vector field")
  (lambda (w)
    (check-form 'interior-product w)
    (if (= (field-rank w) 1) (w X) (contracted-with X w))))

(define (contracted-with X w)
  (define over (common-over 'interior-product (list X w)))
  (make-field (common-field-home 'interior-product (list w X)) (cdr (field-types w))
              (lambda (C)
                (contract-first (components-over w over C) (target-dimension (place-over over C))
                                (components-over X over C)))
              (lambda () `((interior-product ,(value->datum X)) ,(value->datum w)))
              #:over over #:form? #t))

;; The mean of T over all orders of its arguments, with signs.
(define (Alt T)
  (check-argument 'Alt (lambda (T) (and (field? T) (not (memq '1form (field-types T))))) T
                  "a tensor field of vectors")
  (define k (field-rank T))
  (define orders (permutations (range k)))
  (make-field (field-home T) (field-types T)
              (lambda (C)
                (define n (target-dimension (place-over (field-over T) C)))
                (define Ts (components-in T C))
                (antisymmetric n k
                               (lambda (is)
                                 (g:/ (for/fold ([sum 0]) ([o (in-list orders)])
                                        (g:+ sum (g:* (permutation-sign o)
                                                      (component Ts n (for/list ([p (in-list o)])
                                                                        (list-ref is p))))))
                                      (length orders)))))
              (lambda () (list 'Alt (value->datum T)))
              #:over (field-over T) #:form? #t))
