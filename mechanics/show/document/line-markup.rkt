#lang racket/base
;; A result as markup within a line of another document, such as the manual: spans, and formulas.

(require (only-in xml xexpr->string)
         "page-value.rkt" "shown-result.rkt")

(provide value->line-markup)

;; -> string; or #f for texts, numbers, pictures and tables, which a prompt shows as well
(define (value->line-markup x)
  (define s (and (not (number? x)) (value->shown x)))
  (and (shown-formula? s)
       (xexpr->string `(span ([class "typeset"]) ,@(map within-line (shown->xexprs s void))))))

;; Blocks, which a paragraph may not hold, become spans.
(define (within-line x)
  (cond [(and (pair? x) (memq (car x) '(div p pre)))
         (define class (assq 'class (cadr x)))
         (define kind (symbol->string (car x)))
         (list* 'span
                (cons (list 'class (if class (string-append kind " " (cadr class)) kind))
                      (remq class (cadr x)))
                (map within-line (cddr x)))]
        [(pair? x) (cons (car x) (map within-line (cdr x)))]
        [else x]))
