#lang racket/base
;; Which method integrates: a value, or the name under which the book sets it.

(require "../numeric/ode/dormand-prince-853.rkt" "../numeric/ode/stepper.rkt")

(provide ode-integration-method set-ode-integration-method! integration-method?
         dormand-prince-853
         method-of)

(define (integration-method? x) (method? x))

(define methods (list dormand-prince-853))

(define ode-integration-method
  (make-parameter dormand-prince-853
                  (lambda (m) (method-of 'ode-integration-method m))))

(define (set-ode-integration-method! m)
  (ode-integration-method (method-of 'set-ode-integration-method! m)))

;; A method from a method or its name.
(define (method-of who m)
  (cond [(method? m) m]
        [(for/first ([known (in-list methods)] #:when (eq? (method-name known) m)) known)]
        [else
         (raise-arguments-error who "expected a method of integration or its name"
                                "given" m
                                "names" (map method-name methods))]))
