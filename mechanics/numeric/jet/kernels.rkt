#lang racket/base
;; Kernels: what computes coefficient k of rows from those below k, one closure each.
;;
;; A kernel is a procedure of k > 0.  Several may make one row, each adding its share to what
;; the one before it left; the last may divide.  Convolutions of a row that ends (a linear
;; function of time has two coefficients) run over what there is.

(require racket/flonum
         racket/unsafe/ops
         "convolution.rkt")

(provide sum-kernels product-kernels square-kernels shared-product-kernels
         differential-kernel pair-kernel leading-kernel differential-leading-kernel
         root-kernel power-kernel reciprocal-kernel
         derivative-kernel integral-kernel
         (struct-out weighed) (struct-out product) (struct-out target))

;; weight times a row; weight times a product of rows of the degrees given, or +inf.0 for one
;; that does not end
(struct weighed (weight row) #:authentic)
(struct product (weight a a-degree b b-degree) #:authentic)
;; a row that becomes weight times a product of `a` and another
(struct target (row weight a) #:authentic)

;; ---------------------------------------------------------------------------
;; Sums

;; In groups of at most three: (make group add?) makes the kernel of each, of which the first
;; stores and the others add.
(define (grouped things add? make)
  (let loop ([things things] [add? add?])
    (cond [(null? things) '()]
          [else
           (define n (min 3 (length things)))
           (define-values (group rest) (split things n))
           (cons (make group add?) (loop rest #t))])))

(define (split xs n)
  (for/fold ([group '()] [rest xs] #:result (values (reverse group) rest)) ([_ (in-range n)])
    (values (cons (car rest) group) (cdr rest))))

;; r_k = x or r_k + x, as `add?` says when the kernel is made
(define-syntax-rule (storing add? r k x wrap)
  (if add?
      (lambda (k) (wrap (lambda-result r k (unsafe-fl+ (at r k) x))))
      (lambda (k) (wrap (lambda-result r k x)))))
(define-syntax-rule (lambda-result r k x) (put! r k x))

;; Σ weight row
(define (sum-kernels r terms add?)
  (grouped terms add?
           (lambda (group add?)
             (define ws (map weighed-weight group))
             (define rows (map weighed-row group))
             (apply (case (length group) [(1) sum-1] [(2) sum-2] [else sum-3])
                    r add? (append ws rows)))))

(define-syntax-rule (define-sum name (w x) ...)
  (define (name r add? w ... x ...)
    (if add?
        (lambda (k) (put! r k (total (at r k) (unsafe-fl* w (at x k)) ...)))
        (lambda (k) (put! r k (total (unsafe-fl* w (at x k)) ...))))))

(define-syntax total
  (syntax-rules ()
    [(_ x) x]
    [(_ x y . more) (total (unsafe-fl+ x y) . more)]))

(define-sum sum-1 (u x))
(define-sum sum-2 (u x) (v y))
(define-sum sum-3 (u x) (v y) (w z))

;; ---------------------------------------------------------------------------
;; Products

;; Σ weight a b
(define (product-kernels r products add?)
  (define-values (ending endless)
    (for/fold ([ending '()] [endless '()]) ([p (in-list (reverse products))])
      (if (ends? p) (values (cons p ending) endless) (values ending (cons p endless)))))
  (append (grouped endless add? (lambda (group add?) (endless-products r group add?)))
          (for/list ([p (in-list ending)] [k (in-naturals)])
            (ending-product r p (or add? (pair? endless) (> k 0))))))

(define (ends? p) (< (min (product-a-degree p) (product-b-degree p)) +inf.0))

(define (endless-products r group add?)
  (apply (case (length group) [(1) products-1] [(2) products-2] [else products-3])
         r add?
         (append (map product-weight group) (map product-a group) (map product-b group))))

(define-syntax-rule (define-products name (w a b s) ...)
  (define (name r add? w ... a ... b ...)
    (if add?
        (lambda (k)
          (convolve k 0 k ([s a b] ...) (put! r k (total (at r k) (unsafe-fl* w s) ...))))
        (lambda (k)
          (convolve k 0 k ([s a b] ...) (put! r k (total (unsafe-fl* w s) ...)))))))

(define-products products-1 (u a b s))
(define-products products-2 (u a b s) (v c d t))
(define-products products-3 (u a b s) (v c d t) (w e f q))

(define (ending-product r p add?)
  (define-values (a b w) (values (product-a p) (product-b p) (product-weight p)))
  (define la (last-index (product-a-degree p)))
  (define lb (last-index (product-b-degree p)))
  (lambda (k)
    (define low (greater 0 (unsafe-fx- k lb)))
    (convolve k low (smaller k la) ([s a b])
              (put! r k (if add? (unsafe-fl+ (at r k) (unsafe-fl* w s)) (unsafe-fl* w s))))))

;; A degree as an index: of a row that does not end one that is never reached.
(define (last-index degree) (if (< degree +inf.0) degree 1000000))

;; Σ weight row²
(define (square-kernels r terms add?)
  (grouped terms add?
           (lambda (group add?)
             (apply (case (length group) [(1) squares-1] [(2) squares-2] [else squares-3])
                    r add? (append (map weighed-weight group) (map weighed-row group))))))

(define-syntax-rule (define-squares name (w a s) ...)
  (define (name r add? w ... a ...)
    (if add?
        (lambda (k)
          (convolve-halves k 0 ([s a] ...)
                           (put! r k (total (at r k) (unsafe-fl* w s) ...))))
        (lambda (k)
          (convolve-halves k 0 ([s a] ...) (put! r k (total (unsafe-fl* w s) ...)))))))

(define-squares squares-1 (u a s))
(define-squares squares-2 (u a s) (v b t))
(define-squares squares-3 (u a s) (v b t) (w c q))

;; Each target becomes the product of its row and b, endless ones.
(define (shared-product-kernels targets b)
  (grouped targets #f
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

;; r_k = or += weight Σ d_j b_{k−j}, j from 1, where d ends with its degree
(define (differential-kernel r weight d degree b add?)
  (define end (last-index degree))
  (lambda (k)
    (convolve k 1 (smaller k end) ([s d b])
              (put! r k (if add?
                            (unsafe-fl+ (at r k) (unsafe-fl* weight s))
                            (unsafe-fl* weight s))))))

;; r' = u p a' and p' = v r a', given d of a
(define (pair-kernel r u p v d degree)
  (define end (last-index degree))
  (lambda (k)
    (define order (unsafe-fx->fl k))
    (convolve k 1 (smaller k end) ([s d p] [t d r])
              (begin (put! r k (unsafe-fl/ (unsafe-fl* u s) order))
                     (put! p k (unsafe-fl/ (unsafe-fl* v t) order))))))

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
