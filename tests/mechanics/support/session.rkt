#lang racket/base
;; Checks for files that read like a session with `mechanics`.

(require (only-in mechanics expression simplify verify-equal verdict-status) "checks.rkt")

(provide check-prints check-unsimplified check-identity)

;; The value, simplified, is this expression, up to the order of sums and products.
(define-check (check-prints value expected)
  (define got (expression (simplify value)))
  (with-check-info (['got got] ['expected expected])
    (unless (equal? (ordered got) (ordered expected)) (fail-check))))

(define (ordered d)
  (cond [(not (pair? d)) d]
        [(memq (car d) '(+ *))
         (cons (car d) (sort (map ordered (cdr d)) string<? #:key (lambda (x) (format "~s" x))))]
        [else (map ordered d)]))

;; The value as it stands is this expression.
(define-check (check-unsimplified value expected)
  (define got (expression value))
  (with-check-info (['got got] ['expected expected])
    (unless (equal? got expected) (fail-check))))

;; The values are proved to be equal.
(define-check (check-identity value expected)
  (define verdict (verify-equal value expected))
  (with-check-info (['verdict verdict])
    (unless (eq? (verdict-status verdict) 'proved) (fail-check))))
