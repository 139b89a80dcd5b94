#lang racket/base
;; (interact ([k 1 10] ...) body ...): a value that depends on controls (interaction.rkt).  In the
;; body the names of the controls are variables.

(require (for-syntax racket/base
                     "control-syntax.rkt")
         "on-demand.rkt")

(provide interact)

(define-syntax (interact stx)
  (syntax-case stx ()
    [(_ (control ...) body ...)
     (let ()
       (define-values (names makers)
         (for/lists (names makers) ([c (in-list (syntax->list #'(control ...)))])
           (control-form stx c)))
       (check-form stx names (syntax->list #'(body ...)))
       #`(make-interaction (list #,@makers) (lambda #,names body ...) '(body ...)))]
    [_ (raise-syntax-error #f "expected controls and a body: (interact ([k 1 10]) body)" stx)]))

(define-for-syntax (check-form stx names body)
  (when (null? names)
    (raise-syntax-error #f "there are no controls, as in (interact ([k 1 10]) body)" stx))
  (define twice (check-duplicate-identifier names))
  (when twice
    (raise-syntax-error #f (format "two controls have the name ~a" (syntax-e twice)) stx twice))
  (when (null? body)
    (raise-syntax-error #f "the body is missing, an expression whose value is shown" stx)))
