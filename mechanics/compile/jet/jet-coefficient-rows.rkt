#lang racket/base
;; Rows of coefficients for the nodes of a graph, and the recurrences that fill them, in order.

(require "../../numeric/Taylor/expansion.rkt" "../../numeric/Taylor/recurrence-list.rkt")

(provide make-rows row-of spare-row degree derivative-row emit! emit-always! emit-start!
         rows->recurrences)

;; degrees : of the nodes, whose rows have their ids for numbers; derivatives : id -> row;
;; spare : how many rows belong to no node
;; starts, steps : recurrences of order 0 and of those above, the latest first, a step with the
;; degree of its row
(struct rows (degrees derivatives [spare #:mutable] [starts #:mutable] [steps #:mutable])
  #:authentic)

(define (make-rows degrees) (rows degrees (make-hasheqv) 0 '() '()))

(define (degree r id) (vector-ref (rows-degrees r) id))
(define (row-of r id) (row id (degree r id)))
(define (row-count r) (+ (vector-length (rows-degrees r)) (rows-spare r)))

(define (spare-row r [degree +inf.0])
  (define index (row-count r))
  (set-rows-spare! r (+ 1 (rows-spare r)))
  (row index degree))

;; The row of k x_k, which is filled once x is.
(define (derivative-row r id)
  (hash-ref! (rows-derivatives r) id
             (lambda ()
               (define d (spare-row r (degree r id)))
               (emit! r id (make-recurrence 'derivative d (row-of r id)))
               d)))

;; For orders above 0.  A row that does not vary takes none.
(define (emit! r id . recurrences)
  (define last (degree r id))
  (for ([x (in-list recurrences)] #:when (> last 0))
    (set-rows-steps! r (cons (cons last x) (rows-steps r)))))

(define (emit-start! r recurrence) (set-rows-starts! r (cons recurrence (rows-starts r))))

;; For order 0 as for others.
(define (emit-always! r id recurrence)
  (emit-start! r recurrence)
  (emit! r id recurrence))

;; kept : as make-recurrences has it; states, slopes : ids
(define (rows->recurrences kept r states slopes follow?)
  (define steps (reverse (rows-steps r)))
  (define (rows-of ids) (for/list ([id (in-list ids)]) (row-of r id)))
  (make-recurrences kept (row-count r) (rows-of states) (rows-of slopes) (reverse (rows-starts r))
                    (for/list ([s (in-list steps)] #:when (< (car s) +inf.0)) s)
                    (for/list ([s (in-list steps)] #:when (= (car s) +inf.0)) (cdr s))
                    follow?))
