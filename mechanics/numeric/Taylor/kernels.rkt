#lang racket/base
;; Kernels: what computes coefficient k of rows from those below k, one closure each.
;;
;; A kernel is a procedure of k > 0.  Several may make one row, each adding its share to what
;; the one before it left; the last may divide.  Convolutions of a row that ends (a linear
;; function of time has two coefficients) run over what there is.

(require racket/flonum
         racket/list
         racket/unsafe/ops
         "../unboxed-loop.rkt" "convolution.rkt")

(provide sum-kernels product-kernels square-kernels shared-product-kernels
         differential-kernel leading-kernel differential-leading-kernel
         root-kernel power-kernel reciprocal-kernel
         derivative-kernel integral-kernel pair-kernel
         itself (struct-out weighed) (struct-out product) (struct-out target))

;; weight times a row; weight times a product of rows of the degrees given, or +inf.0 for one
;; that does not end
(struct weighed (weight row) #:authentic)
(struct product (weight a a-degree b b-degree) #:authentic)
;; a row that becomes the product of `a` and another
(struct target (row a) #:authentic)

;; ---------------------------------------------------------------------------
;; Sums

;; What is there before a kernel adds to it: #f for nothing; or a weighed row, which may be
;; the one that the kernel makes.
(define (itself r) (weighed 1.0 r))

;; In groups of at most three: make is applied to r, the base and each of the parts of a group,
;; those of all its things in turn; the first group begins with the base and the others with what
;; is there.
(define (grouped r things base make . parts)
  (let loop ([things things] [base base])
    (cond [(null? things) '()]
          [else
           (define-values (group rest) (split-at things (min 3 (length things))))
           (cons (apply make r base (append-map (lambda (part) (map part group)) parts))
                 (loop rest (itself r)))])))

;; base + Σ weight row
(define (sum-kernels r terms base) (grouped r terms base sums weighed-weight weighed-row))

;; A kernel of k that stores in r_k the sum of the base and of the terms, in the loop `within`.
(define-syntax-rule (storing-kernel r k base (within loop-part ...) term ...)
  (if base
      (let ([b0 (weighed-weight base)] [from (weighed-row base)])
        (lambda (k)
          (within k loop-part ...
                  (put! r k (sum (unsafe-fl* b0 (at from k)) term ...)))))
      (lambda (k) (within k loop-part ... (put! r k (sum term ...))))))

(define-syntax-rule (at-once k body) body)

(define-syntax-rule (define-sums name ([w x] ...) ...)
  (define name
    (case-lambda
      [(r base w ... x ...) (storing-kernel r k base (at-once) (unsafe-fl* w (at x k)) ...)]
      ...)))

(define-sums sums ([u x]) ([u x] [v y]) ([u x] [v y] [w z]))

;; ---------------------------------------------------------------------------
;; Products

;; base + Σ weight a b
(define (product-kernels r products base)
  (define-values (ending endless) (partition ends? products))
  (append (grouped r endless base products-of product-weight product-a product-b)
          (for/list ([p (in-list ending)] [k (in-naturals)])
            (ending-product r p (if (or (pair? endless) (> k 0)) (itself r) base)))))

(define (ends? p) (< (min (product-a-degree p) (product-b-degree p)) +inf.0))

(define-syntax-rule (define-products name ([w a b s] ...) ...)
  (define name
    (case-lambda
      [(r base w ... a ... b ...)
       (storing-kernel r k base (convolve 0 k ([s a b] ...)) (unsafe-fl* w s) ...)]
      ...)))

(define-products products-of
  ([u a b s]) ([u a b s] [v c d t]) ([u a b s] [v c d t] [w e f q]))

(define (ending-product r p base)
  (define-values (a b w) (values (product-a p) (product-b p) (product-weight p)))
  (define la (last-index (product-a-degree p)))
  (define lb (last-index (product-b-degree p)))
  (storing-kernel r k base
                  (convolve (greater 0 (unsafe-fx- k lb)) (smaller k la) ([s a b]))
                  (unsafe-fl* w s)))

;; A degree as an index: of a row that does not end one that is never reached.
(define (last-index degree) (if (< degree +inf.0) degree 1000000))

;; base + Σ weight row²
(define (square-kernels r terms base) (grouped r terms base squares weighed-weight weighed-row))

(define-syntax-rule (define-squares name ([w a s] ...) ...)
  (define name
    (case-lambda
      [(r base w ... a ...)
       (storing-kernel r k base (convolve-halves 0 ([s a] ...)) (unsafe-fl* w s) ...)]
      ...)))

(define-squares squares ([u a s]) ([u a s] [v b t]) ([u a s] [v b t] [w c q]))

;; Each target becomes the product of its row and b, endless ones.
(define (shared-product-kernels targets b)
  (grouped b targets #f shared-products target-row target-a))

(define-syntax-rule (define-shared-products name ([r a s] ...) ...)
  (define name
    (case-lambda
      [(b base r ... a ...)
       (lambda (k) (convolve k 0 k ([s a b] ...) (begin (put! r k s) ...)))]
      ...)))

(define-shared-products shared-products
  ([r a s]) ([r a s] [q c t]) ([r a s] [q c t] [p d x]))

;; ---------------------------------------------------------------------------
;; Differential equations: with d_j = j r_j they are about products as well

;; d_k = k r_k
(define (derivative-kernel d r) (lambda (k) (put! d k (unsafe-fl* (unsafe-fx->fl k) (at r k)))))

;; r_k = d_k / k
(define (integral-kernel r d) (lambda (k) (put! r k (unsafe-fl/ (at d k) (unsafe-fx->fl k)))))

;; r_k = base + weight Σ d_j b_{k−j}, j from 1, where d ends with its degree
(define (differential-kernel r weight d degree b base)
  (define end (last-index degree))
  (storing-kernel r k base (convolve 1 (smaller k end) ([s d b])) (unsafe-fl* weight s)))

;; r' = u p a' and p' = v r a', given d of a: two functions of which each has the other in its
;; derivative, as sin and cos.
(define (pair-kernel r u p v d degree)
  (if (= degree 1) (turning-kernel r u p v d) (general-pair-kernel r u p v d degree)))

(define (general-pair-kernel r u p v d degree)
  (define end (last-index degree))
  (lambda (k)
    (define order (unsafe-fx->fl k))
    (convolve k 1 (smaller k end) ([s d p] [t d r])
              (begin (put! r k (unsafe-fl/ (unsafe-fl* u s) order))
                     (put! p k (unsafe-fl/ (unsafe-fl* v t) order))))))

;; The angle of a drive grows as the time does: coefficient k of its sine and cosine follows from
;; the one before alone.
(define (turning-kernel r u p v d)
  (lambda (k)
    (define order (unsafe-fx->fl k))
    (define rate (at d 1))
    (define before (unsafe-fx- k 1))
    (put! r k (unsafe-fl/ (unsafe-fl* (unsafe-fl* u rate) (at p before)) order))
    (put! p k (unsafe-fl/ (unsafe-fl* (unsafe-fl* v rate) (at r before)) order))))

;; ---------------------------------------------------------------------------
;; Equations l r = x for r, where x_k has been stored in r_k

(define (leading-kernel r l degree)
  (define end (last-index degree))
  (lambda (k)
    (convolve k 1 (smaller k end) ([s l r])
              (put! r k (unsafe-fl/ (unsafe-fl- (at r k) s) (at l 0))))))

;; l r' = x', of rows d of derivatives
(define (differential-leading-kernel d l)
  (lambda (k)
    (convolve k 1 (unsafe-fx- k 1) ([s d l])
              (put! d k (unsafe-fl/ (unsafe-fl- (at d k) s) (at l 0))))))

;; r r = a
(define (root-kernel r a)
  (lambda (k)
    (convolve-halves k 1 ([s r])
                     (put! r k (unsafe-fl/ (unsafe-fl- (at a k) s)
                                           (unsafe-fl* 2.0 (at r 0)))))))

;; r b = 1
(define (reciprocal-kernel r b)
  (lambda (k)
    (convolve k 1 k ([s b r]) (put! r k (unsafe-fl/ (unsafe-fl- 0.0 s) (at b 0))))))

;; b r' = n b' r: k b₀ r_k = Σ ((n + 1) j − k) b_j r_{k−j}, j from 1
(define (power-kernel r b n)
  (define rise (fl+ n 1.0))
  (lambda (k)
    (define order (unsafe-fx->fl k))
    (let loop ([i 1] [j (unsafe-fx- k 1)] [w (unsafe-fl- rise order)] [s 0.0])
      (if (unsafe-fx< j 0)
          (put! r k (unsafe-fl/ s (unsafe-fl* order (at b 0))))
          (loop (unsafe-fx+ i 1) (unsafe-fx- j 1) (unsafe-fl+ w rise)
                (unsafe-fl+ s (unsafe-fl* w (unsafe-fl* (at b i) (at r j)))))))))
