#lang racket/base
;; Kernels of sums and products: products that only one sum is made of are added up in place,
;; products that share a factor take one loop (jet-sharing.rkt).

(require racket/flonum
         "jet-nodes.rkt" "jet-rows.rkt"
         "../../numeric/Taylor/kernels.rkt")

(provide emit-sum! emit-product!)

(define (emit-sum! r nodes id uses)
  (define n (vector-ref nodes id))
  (define x (row r id))
  (define constant (real->double-flonum (cadr n)))
  (define-values (products others)
    (for/fold ([products '()] [others '()]) ([t (in-list (reverse (cddr n)))])
      (if (vector-ref uses (car t))
          (values (cons t products) others)
          (values products (cons t others)))))
  ;; one multiple of a row is where the first product begins
  (define (kernels varying? base)
    (define kept
      (for/list ([t (in-list others)] #:when (or (not varying?) (> (degree r (car t)) 0)))
        (weighed (real->double-flonum (cdr t)) (row r (car t)))))
    (if (and (not base) (pair? products) (pair? kept) (null? (cdr kept)))
        (products-of r nodes x products (car kept))
        (let ([sums (sum-kernels x kept base)])
          (append sums (products-of r nodes x products (if (pair? sums) (itself x) base))))))
  (unless (fl= constant 0.0) (emit-start! r (lambda () (flvector-set! x 0 constant))))
  (for ([kernel (in-list (kernels #f (if (fl= constant 0.0) #f (itself x))))])
    (emit-start! r (lambda () (kernel 0))))
  (for ([kernel (in-list (kernels #t #f))]) (emit! r id kernel)))

;; Kernels of x = base + Σ c a b, squares among them.
(define (products-of r nodes x terms base)
  (define-values (squares others)
    (for/fold ([squares '()] [others '()]) ([t (in-list terms)])
      (define n (vector-ref nodes (car t)))
      (define c (real->double-flonum (cdr t)))
      (if (and (= (cadr n) (caddr n)) (= +inf.0 (degree r (cadr n))))
          (values (cons (weighed c (row r (cadr n))) squares) others)
          (values squares (cons (a-product r c (cadr n) (caddr n)) others)))))
  (define first (square-kernels x squares base))
  (append first (product-kernels x others (if (pair? first) (itself x) base))))

(define (a-product r c a b)
  (product c (row r a) (degree r a) (row r b) (degree r b)))

(define (emit-product! r nodes id shared)
  (define group (hash-ref shared id #f))
  (define x (row r id))
  (cond [(eq? group 'done) (void)]
        [group
         (define factor (car group))
         (define targets
           (for/list ([k (in-list (cons id (cdr group)))])
             (define xs (node-operands (vector-ref nodes k)))
             (target (row r k) 1.0 (row r (if (= (car xs) factor) (cadr xs) (car xs))))))
         (for ([kernel (in-list (shared-product-kernels targets (row r factor)))])
           (emit-always! r id kernel))]
        [else
         (for ([kernel (in-list (products-of r nodes x (list (cons id 1.0)) #f))])
           (emit-always! r id kernel))]))
