#lang racket/base
;; Rows of coefficients for the nodes of a graph, and the kernels that fill them, in order.

(require racket/flonum
         "../../numeric/Taylor/expansion.rkt" "../../numeric/Taylor/kernels.rkt")

(provide make-rows row spare-row degree derivative-row emit! emit-always! emit-start!
         starts ending-kernels endless-kernels)

;; degrees : of the nodes; order : of the expansion; rows, derivatives : id -> flvector
;; starts, kernels : the latest first; a kernel with the degree of its row
(struct rows (degrees order rows derivatives [starts #:mutable] [kernels #:mutable]) #:authentic)

(define (make-rows degrees order) (rows degrees order (make-hasheqv) (make-hasheqv) '() '()))

(define (spare-row r) (make-flvector (+ 1 (rows-order r))))
(define (row r id) (hash-ref! (rows-rows r) id (lambda () (spare-row r))))
(define (degree r id) (vector-ref (rows-degrees r) id))

;; The row of k x_k, which is filled once x is.
(define (derivative-row r id)
  (hash-ref! (rows-derivatives r) id
             (lambda ()
               (define d (spare-row r))
               (emit! r id (derivative-kernel d (row r id)))
               d)))

;; For orders above 0.  A row that does not vary takes none.
(define (emit! r id . kernels)
  (define last (degree r id))
  (for ([kernel (in-list kernels)] #:when (> last 0))
    (set-rows-kernels! r (cons (cons last kernel) (rows-kernels r)))))

(define (emit-start! r thunk) (set-rows-starts! r (cons thunk (rows-starts r))))

;; For order 0 as for others.
(define (emit-always! r id kernel)
  (emit-start! r (lambda () (kernel 0)))
  (emit! r id kernel))

(define (starts r) (list->vector (reverse (rows-starts r))))

(define (ending-kernels r)
  (for/list ([k (in-list (reverse (rows-kernels r)))] #:when (< (car k) +inf.0))
    (ending (car k) (cdr k))))

(define (endless-kernels r)
  (for/vector ([k (in-list (reverse (rows-kernels r)))] #:when (= (car k) +inf.0)) (cdr k)))
