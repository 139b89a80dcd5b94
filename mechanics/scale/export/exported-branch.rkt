#lang racket/base
;; A branch ready for export: its family of systems, with a symbol for the parameter, and its points
;; as starts that the exported program reads, each with the value of the parameter.

(require racket/string
         "exported-system.rkt"
         "../../dynamics/continuation/branch.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt"
         "../../value/shape.rkt")

(provide make-exported-branch)

;; order : a list with the symbol of the parameter, or #f
(define (make-exported-branch who b example name order derivatives?)
  (when (and order (not (= 1 (length order))))
    (complain who "a branch has one parameter, as in #:parameters '(A)\n  given: ~a"
              (value->text order)))
  (define symbol (if order (car order) 'parameter))
  (define s (make-exported who (branch-system b symbol) example name order derivatives?))
  (struct-copy exported s [tables (branch-tables b (pair? (exported-parameters s)))]))

(define (branch-tables b parameter?)
  (define starts
    (for/list ([state (in-list (branch-states b))] [p (in-list (branch-parameters b))])
      (append (scalars state) (if parameter? (list p) '()))))
  (define periods (branch-periods b))
  (cons (cons "starts.txt" (rows->text starts))
        (if periods (list (cons "periods.txt" (rows->text (map list periods)))) '())))

(define (rows->text rows)
  (string-append*
   (for/list ([row (in-list rows)])
     (format "~a\n"
             (string-join (for/list ([x (in-list row)]) (number->string (exact->inexact x))))))))
