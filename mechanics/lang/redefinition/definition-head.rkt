#lang racket/base
;; Heads of definitions: ((L m k) local) tells how L is called.

(provide definition-head head-name-in head->header)

;; A definition, a datum -> its head, a procedure written out as a value being part of it:
;; (f x) for (define f (lambda (x) ...)), also
(define (definition-head d)
  (define head (cadr d))
  (if (and (pair? (cddr d)) (null? (cdddr d))) (with-procedure head (caddr d)) head))

(define (with-procedure head value)
  (if (and (list? value) (> (length value) 2) (memq (car value) '(lambda λ)))
      (let ([inner (cons head (cadr value))])
        (if (null? (cdddr value)) (with-procedure inner (caddr value)) inner))
      head))

;; The name that a head defines, or #f
(define (head-name-in head)
  (cond [(pair? head) (head-name-in (car head))]
        [(symbol? head) head]
        [else #f]))

;; The first call of a curried head: (L m k).
(define (head->header head)
  (if (and (pair? head) (pair? (car head))) (head->header (car head)) head))
