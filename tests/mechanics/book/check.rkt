#lang racket/base
;; Checks for files that read like a session with `mechanics`.

(require rackunit
         (only-in mechanics expression simplify))

(provide check-prints check-unsimplified check-says)

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

;; (check-says text expression): the expression raises exactly this message.
(define-syntax-rule (check-says text expression)
  (check-exn (lambda (e)
               (or (and (exn:fail:contract? e) (equal? (exn-message e) text))
                   (begin (eprintf "said: ~a\n" (exn-message e)) #f)))
             (lambda () expression)))
