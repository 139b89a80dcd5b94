#lang racket/base
;; Components of tensors: n^k expressions in a vector, the last index running fastest.

(require "../generic/arithmetic.rkt")

(provide build-components component components-from sum-of-products
         contract-first contract-all apply-to-index add-components
         sum-over times rates-along)

;; f : indices, a list of k -> component
(define (build-components n k f)
  (define size (expt n k))
  (define v (make-vector size 0))
  (for ([place (in-range size)])
    (vector-set! v place (f (indices-of place n k))))
  v)

(define (indices-of place n k)
  (for/fold ([indices '()] [place place] #:result indices) ([_ (in-range k)])
    (values (cons (remainder place n) indices) (quotient place n))))

(define (place-of n indices)
  (for/fold ([place 0]) ([i (in-list indices)]) (+ (* n place) i)))

(define (component v n indices) (vector-ref v (place-of n indices)))

;; T[i …], the components whose first index is i
(define (components-from T n i)
  (define size (quotient (vector-length T) n))
  (for/vector #:length size ([j (in-range size)]) (vector-ref T (+ (* i size) j))))

(define (add-components S T) (for/vector ([x (in-vector S)] [y (in-vector T)]) (g:+ x y)))

;; Σ f(i) for i below n; sums of many exact zeros cost nothing.
(define (sum-over n f)
  (for/fold ([sum 0]) ([i (in-range n)])
    (define term (f i))
    (if (eqv? term 0) sum (g:+ sum term))))

;; Σ aᵢ bᵢ, where b is computed only beside an a other than 0
(define (sum-of-products n a b)
  (sum-over n (lambda (i)
                (define x (a i))
                (if (eqv? x 0) 0 (times x (b i))))))

(define (times x y) (if (or (eqv? x 0) (eqv? y 0)) 0 (g:* x y)))

;; Σᵢ T[i …] aᵢ: the components of the rest
(define (contract-first T n a)
  (define size (quotient (vector-length T) n))
  (for/vector #:length size ([place (in-range size)])
    (sum-of-products n (lambda (i) (vector-ref a i))
                     (lambda (i) (vector-ref T (+ (* i size) place))))))

;; The same for one vector after the other: the components that are left
(define (contract-all T n vectors)
  (for/fold ([rest T]) ([a (in-list vectors)]) (contract-first rest n a)))

;; Σₖ vₖ slopes[k][j], for each j
(define (rates-along v slopes)
  (for/vector #:length (vector-length (vector-ref slopes 0))
              ([j (in-range (vector-length (vector-ref slopes 0)))])
    (sum-of-products (vector-length v) (lambda (k) (vector-ref v k))
                     (lambda (k) (vector-ref (vector-ref slopes k) j)))))

;; T with index p (of k) replaced by M: T'[… j …] = Σᵢ M(j, i) T[… i …]
(define (apply-to-index T n k p M)
  (define stride (expt n (- k p 1)))
  (for/vector #:length (vector-length T) ([place (in-range (vector-length T))])
    (define j (remainder (quotient place stride) n))
    (define base (- place (* j stride)))
    (sum-of-products n (lambda (i) (vector-ref T (+ base (* i stride)))) (lambda (i) (M j i)))))
