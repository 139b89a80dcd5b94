#lang racket/base
;; Kernels: what computes coefficient k of rows from those below k, one closure each.
;;
;; A kernel is a procedure of k > 0.  Several may make one row, each adding its share to what
;; the one before it left; the last may divide.  Convolutions of a row that ends (a linear
;; function of time has two coefficients) run over what there is.

(require racket/flonum
         racket/list
         racket/unsafe/ops
         "convolution.rkt")

(provide sum-kernels product-kernels square-kernels shared-product-kernels
         differential-kernel leading-kernel differential-leading-kernel
         root-kernel power-kernel reciprocal-kernel
         derivative-kernel integral-kernel
         itself (struct-out weighed) (struct-out product) (struct-out target)
         last-index)

;; weight times a row; weight times a product of rows of the degrees given, or +inf.0 for one
;; that does not end
(struct weighed (weight row) #:authentic)
(struct product (weight a a-degree b b-degree) #:authentic)
;; a row that becomes weight times a product of `a` and another
(struct target (row weight a) #:authentic)

;; ---------------------------------------------------------------------------
;; Sums

;; What is there before a kernel adds to it: #f for nothing; or a weighed row, which may be
;; the one that the kernel makes.
(define (itself r) (weighed 1.0 r))

;; In groups of at most three: (make group base) makes the kernel of each, of which the first
;; begins with the base and the others with what is there.
(define (grouped r things base make)
  (let loop ([things things] [base base])
    (cond [(null? things) '()]
          [else
           (define n (min 3 (length things)))
           (define-values (group rest) (split-at things n))
           (cons (make group base) (loop rest (itself r)))])))

;; base + Σ weight row
(define (sum-kernels r terms base)
  (grouped r terms base
           (lambda (group base)
             (apply (case (length group) [(1) sum-1] [(2) sum-2] [else sum-3])
                    r base (append (map weighed-weight group) (map weighed-row group))))))

;; A kernel of k that stores in r_k the sum of the base and of the terms, in the loop `within`.
(define-syntax-rule (storing-kernel r k base (within loop-part ...) term ...)
  (if base
      (let ([b0 (weighed-weight base)] [from (weighed-row base)])
        (lambda (k)
          (within k loop-part ...
                  (put! r k (total (unsafe-fl* b0 (at from k)) term ...)))))
      (lambda (k) (within k loop-part ... (put! r k (total term ...))))))

(define-syntax-rule (at-once k body) body)

(define-syntax-rule (define-sum name (w x) ...)
  (define (name r base w ... x ...)
    (storing-kernel r k base (at-once) (unsafe-fl* w (at x k)) ...)))

(define-syntax total
  (syntax-rules ()
    [(_ x) x]
    [(_ x y . more) (total (unsafe-fl+ x y) . more)]))

(define-sum sum-1 (u x))
(define-sum sum-2 (u x) (v y))
(define-sum sum-3 (u x) (v y) (w z))

;; ---------------------------------------------------------------------------
;; Products

;; base + Σ weight a b
(define (product-kernels r products base)
  (define-values (ending endless) (partition ends? products))
  (append (grouped r endless base (lambda (group base) (endless-products r group base)))
          (for/list ([p (in-list ending)] [k (in-naturals)])
            (ending-product r p (if (or (pair? endless) (> k 0)) (itself r) base)))))

(define (ends? p) (< (min (product-a-degree p) (product-b-degree p)) +inf.0))

(define (endless-products r group base)
  (apply (case (length group) [(1) products-1] [(2) products-2] [else products-3])
         r base
         (append (map product-weight group) (map product-a group) (map product-b group))))

(define-syntax-rule (define-products name (w a b s) ...)
  (define (name r base w ... a ... b ...)
    (storing-kernel r k base (convolve 0 k ([s a b] ...)) (unsafe-fl* w s) ...)))

(define-products products-1 (u a b s))
(define-products products-2 (u a b s) (v c d t))
(define-products products-3 (u a b s) (v c d t) (w e f q))

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
(define (square-kernels r terms base)
  (grouped r terms base
           (lambda (group base)
             (apply (case (length group) [(1) squares-1] [(2) squares-2] [else squares-3])
                    r base (append (map weighed-weight group) (map weighed-row group))))))

(define-syntax-rule (define-squares name (w a s) ...)
  (define (name r base w ... a ...)
    (storing-kernel r k base (convolve-halves 0 ([s a] ...)) (unsafe-fl* w s) ...)))

(define-squares squares-1 (u a s))
(define-squares squares-2 (u a s) (v b t))
(define-squares squares-3 (u a s) (v b t) (w c q))

;; Each target becomes the product of its row and b, endless ones.
(define (shared-product-kernels targets b)
  (grouped #f targets #f
           (lambda (group _)
             (apply (case (length group) [(1) shared-1] [(2) shared-2] [else shared-3])
                    b (append (map target-row group) (map target-weight group)
                              (map target-a group))))))

(define-syntax-rule (define-shared name (r w a s) ...)
  (define (name b r ... w ... a ...)
    (lambda (k)
      (convolve k 0 k ([s a b] ...) (begin (put! r k (unsafe-fl* w s)) ...)))))

(define-shared shared-1 (r u a s))
(define-shared shared-2 (r u a s) (q v c t))
(define-shared shared-3 (r u a s) (q v c t) (p w d x))

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
