#lang racket/base
;; How a value is typeset: the constructors of the tree of its notation.
;;
;; A kind of value says it in its `notation` (kind.rkt), any other struct of ours by
;; `prop:notation`; both are procedures that get the value and one that gives the tree of any
;; value within it.  Who says nothing is typeset as the S-expression it prints as.
;;
;; The tree (algebra/notation/tree.rkt) is loaded when the first one is made.

(require "on-demand.rkt")

(provide prop:notation has-notation? notation-of
         ;; trees
         tree:column tree:across tree:grid tree:listing tree:word tree:row tree:relation
         tree:datum tree:sum tree:product
         ;; layouts
         statement datum-notation text-notation)

(define-values (prop:notation has-notation? notation-of) (make-struct-type-property 'notation))

(require-on-demand
 ["../algebra/notation/tree.rkt"
  [column tree:column] [across tree:across] [grid tree:grid] [listing tree:listing]
  [word tree:word] [row tree:row] [relation tree:relation]
  [report tree:report] [report-line tree:report-line] [application tree:application]]
 ["../algebra/notation/tree-arithmetic.rkt" [sum-of tree:sum] [product-of tree:product]]
 ["../algebra/notation/formula.rkt" [plain-datum->tree tree:datum]])

;; ---------------------------------------------------------------------------
;; Statements in words

;; Lines (depth label part ...): a label, and trees and words beside it.
(define (statement . lines)
  (tree:report
   (for/list ([l (in-list lines)])
     (tree:report-line (car l) (cadr l)
                       (for/list ([p (in-list (cddr l))]) (if (string? p) (tree:word p) p))))))

;; A list that begins with a name: as the application of the function of that name.
(define (datum-notation d see)
  (if (and (pair? d) (symbol? (car d)) (list? d))
      (tree:application (tree:word (symbol->string (car d))) (map see (cdr d)) #f)
      (see d)))

;; The lines of a text, two columns of indentation being a depth.
(define (text-notation text see)
  (tree:report
   (for/list ([l (in-list (regexp-split #rx"\n" text))])
     (define indentation (cdar (regexp-match-positions #rx"^ *" l)))
     (tree:report-line (quotient indentation 2) (substring l indentation) '()))))
