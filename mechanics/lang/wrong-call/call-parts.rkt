#lang racket/base
;; What cannot be meant in a call, and would be passed over in silence or told in other words:
;; keywords without their values, (evolve-trajectory f state 10 #:tolerance); and quotes that
;; touch what stands before them, (+ 1 2'x) and (x' t), which are read as (+ 1 2 'x) and (x 't).

(require "../written-form.rkt")

(provide check-call)

;; stx : of #%app
(define (check-call stx)
  (define parts (or (syntax->list stx) '(#f)))
  (check-keywords stx (if (null? (cdr parts)) '() (cddr parts)))
  (check-quotes stx (cdr parts)))

(define (fail stx text . parts)
  (raise-syntax-error #f (apply format text parts) (datum->syntax stx (cdr (syntax-e stx)) stx)))

(define (check-keywords stx arguments)
  (let check ([parts arguments])
    (cond [(null? parts) (void)]
          [(not (keyword-argument? (car parts))) (check (cdr parts))]
          [(or (null? (cdr parts)) (keyword-argument? (cadr parts)))
           (fail stx "~s has no value: it stands behind the keyword" (syntax-e (car parts)))]
          [else (check (cddr parts))])))

(define (keyword-argument? stx) (keyword? (syntax-e stx)))

(define (check-quotes stx row)
  (for ([one (in-list row)] [next (in-list (if (null? row) '() (cdr row)))])
    (define d (syntax-e one))
    (when (and (or (symbol? d) (number? d)) (prime-before? one next))
      (if (number? d)
          (fail stx "~a~a is read as two; a product is ~a" d (form->text (syntax->datum next))
                (form->text (list '* d (syntax->datum next))))
          (fail stx "a prime is read as a quote; the derivative of ~a is (D ~a)" d d)))))
