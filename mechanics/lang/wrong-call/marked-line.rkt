#lang racket/base
;; Forms of a module leave their line on the stack while they are evaluated, once for each form:
;; calls get no slower.

(provide at-line marked-line)

(define key (make-continuation-mark-key 'line))

;; (at-line number expression)
(define-syntax-rule (at-line number expression)
  (with-continuation-mark key (cons (#%variable-reference) number) expression))

;; marks -> (source . line) of the innermost form, or #f
(define (marked-line marks)
  (define found (continuation-mark-set-first marks key))
  (and found
       (cons (variable-reference->module-source (car found)) (cdr found))))
