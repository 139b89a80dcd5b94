#lang racket/base
;; Kernels: recurrences as closures, at once and everywhere.
;;
;; A kernel is a procedure of k, which computes coefficient k of its row.

(require racket/flonum
         racket/unsafe/ops
         "convolution.rkt" "linear-system.rkt" "recurrence-list.rkt"
         "../unboxed-loop.rkt" "../vector-map.rkt")

(provide recurrence->kernel)

;; rows : vector of flvectors
(define (recurrence->kernel r rows)
  (define (operand x)
    (cond [(row? x) (vector-ref rows (row-index x))]
          [(weighed? x) (weighed (weighed-weight x) (operand (weighed-row x)))]
          [(vector? x) (vector-map operand x)]
          [else x]))
  (apply (hash-ref makers (recurrence-kind r)) (map operand (recurrence-operands r))))

;; ---------------------------------------------------------------------------
;; Sums

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

(define-syntax-rule (define-products name ([w a b s] ...) ...)
  (define name
    (case-lambda
      [(r base w ... a ... b ...)
       (storing-kernel r k base (convolve 0 k ([s a b] ...)) (unsafe-fl* w s) ...)]
      ...)))

(define-products products
  ([u a b s]) ([u a b s] [v c d t]) ([u a b s] [v c d t] [w e f q]))

(define (ending-product r base w a la b lb)
  (storing-kernel r k base
                  (convolve (greater 0 (unsafe-fx- k lb)) (smaller k la) ([s a b]))
                  (unsafe-fl* w s)))

(define-syntax-rule (define-squares name ([w a s] ...) ...)
  (define name
    (case-lambda
      [(r base w ... a ...)
       (storing-kernel r k base (convolve-halves 0 ([s a] ...)) (unsafe-fl* w s) ...)]
      ...)))

(define-squares squares ([u a s]) ([u a s] [v b t]) ([u a s] [v b t] [w c q]))

(define-syntax-rule (define-shared-products name ([r a s] ...) ...)
  (define name
    (case-lambda
      [(b r ... a ...)
       (lambda (k) (convolve k 0 k ([s a b] ...) (begin (put! r k s) ...)))]
      ...)))

(define-shared-products shared-products
  ([r a s]) ([r a s] [q c t]) ([r a s] [q c t] [p d x]))

;; ---------------------------------------------------------------------------
;; Differential equations: with d_j = j r_j they are about products as well

(define (derivative d r) (lambda (k) (put! d k (unsafe-fl* (unsafe-fx->fl k) (at r k)))))
(define (integral r d) (lambda (k) (put! r k (unsafe-fl/ (at d k) (unsafe-fx->fl k)))))

(define (differential r base weight d last b)
  (storing-kernel r k base (convolve 1 (smaller k last) ([s d b])) (unsafe-fl* weight s)))

(define (pair r u p v d last)
  (lambda (k)
    (define order (unsafe-fx->fl k))
    (convolve k 1 (smaller k last) ([s d p] [t d r])
              (begin (put! r k (unsafe-fl/ (unsafe-fl* u s) order))
                     (put! p k (unsafe-fl/ (unsafe-fl* v t) order))))))

(define (turning r u p v d)
  (lambda (k)
    (define order (unsafe-fx->fl k))
    (define rate (at d 1))
    (define before (unsafe-fx- k 1))
    (put! r k (unsafe-fl/ (unsafe-fl* (unsafe-fl* u rate) (at p before)) order))
    (put! p k (unsafe-fl/ (unsafe-fl* (unsafe-fl* v rate) (at r before)) order))))

;; ---------------------------------------------------------------------------
;; Equations for r

(define (leading r l last)
  (lambda (k)
    (convolve k 1 (smaller k last) ([s l r])
              (put! r k (unsafe-fl/ (unsafe-fl- (at r k) s) (at l 0))))))

(define (differential-leading d l)
  (lambda (k)
    (convolve k 1 (unsafe-fx- k 1) ([s d l])
              (put! d k (unsafe-fl/ (unsafe-fl- (at d k) s) (at l 0))))))

(define (root r a)
  (lambda (k)
    (convolve-halves k 1 ([s r])
                     (put! r k (unsafe-fl/ (unsafe-fl- (at a k) s)
                                           (unsafe-fl* 2.0 (at r 0)))))))

(define (reciprocal r b)
  (lambda (k)
    (convolve k 1 k ([s b r]) (put! r k (unsafe-fl/ (unsafe-fl- 0.0 s) (at b 0))))))

;; k b₀ r_k = Σ ((n + 1) j − k) b_j r_{k−j}, j from 1
(define (power r b n)
  (define rise (fl+ n 1.0))
  (lambda (k)
    (define order (unsafe-fx->fl k))
    (let loop ([i 1] [j (unsafe-fx- k 1)] [w (unsafe-fl- rise order)] [s 0.0])
      (if (unsafe-fx< j 0)
          (put! r k (unsafe-fl/ s (unsafe-fl* order (at b 0))))
          (loop (unsafe-fx+ i 1) (unsafe-fx- j 1) (unsafe-fl+ w rise)
                (unsafe-fl+ s (unsafe-fl* w (unsafe-fl* (at b i) (at r j)))))))))

;; ---------------------------------------------------------------------------
;; Order 0

(define (value r name f . xs)
  (define x (car xs))
  (if (null? (cdr xs))
      (lambda (k) (put! r 0 (f (at x 0))))
      (lambda (k) (put! r 0 (apply f (for/list ([x (in-list xs)]) (flvector-ref x 0)))))))

(define (constant r c) (lambda (k) (put! r 0 c)))
(define (ratio r a b) (lambda (k) (put! r 0 (unsafe-fl/ (at a 0) (at b 0)))))

(define (power-value r b n)
  (define-values (whole half?) (whole-and-half n))
  (if whole
      (lambda (k)
        (define x
          (for/fold ([x (if half? (flsqrt (at b 0)) 1.0)]) ([_ (in-range whole)])
            (fl* x (at b 0))))
        (put! r 0 (if (< n 0) (fl/ 1.0 x) x)))
      (lambda (k) (put! r 0 (flexpt (at b 0) (real->double-flonum n))))))

;; ---------------------------------------------------------------------------

(define makers
  (hasheq 'sums sums 'products products 'squares squares 'ending-product ending-product
          'shared-products shared-products
          'derivative derivative 'integral integral 'differential differential
          'pair pair 'turning turning
          'leading leading 'differential-leading differential-leading
          'root root 'reciprocal reciprocal 'power power 'system system
          'value value 'constant constant 'ratio ratio 'power-value power-value))
