#lang racket/base
;; Keywords of a call without their values: (evolve-trajectory f state 10 #:tolerance)

(provide check-keywords)

;; stx : of #%app
(define (check-keywords stx)
  (define parts (syntax-case stx ()
                  [(_ operator . arguments) (syntax->list #'arguments)]
                  [_ #f]))
  (let check ([parts (or parts '())])
    (cond [(null? parts) (void)]
          [(not (keyword-argument? (car parts))) (check (cdr parts))]
          [(or (null? (cdr parts)) (keyword-argument? (cadr parts)))
           (raise-syntax-error
            #f (format "~s has no value: it stands behind the keyword" (syntax-e (car parts)))
            (datum->syntax stx (cdr (syntax-e stx)) stx))]
          [else (check (cddr parts))])))

(define (keyword-argument? stx) (keyword? (syntax-e stx)))
