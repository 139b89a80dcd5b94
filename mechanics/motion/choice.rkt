#lang racket/base
;; Which method integrates: the name of an adaptive one, as the book gives it, or a
;; method made with a fixed step.
;;
;; The names are here, the methods are loaded when one is used.

(require "../numeric/ode/stepper.rkt")

(provide ode-integration-method set-ode-integration-method! integration-method?
         check-method)

(define names '(Dormand-Prince-853 Dormand-Prince-54 bulirsch-stoer qcrk4 Radau-IIA-5))

(define (integration-method? x) (or (method? x) (and (memq x names) #t)))

(define (check-method who m)
  (unless (integration-method? m)
    (raise-arguments-error who "expected a method of integration or the name of one"
                           "given" m
                           "names" names))
  m)

(define ode-integration-method
  (make-parameter 'Dormand-Prince-853 (lambda (m) (check-method 'ode-integration-method m))))

(define (set-ode-integration-method! m)
  (ode-integration-method (check-method 'set-ode-integration-method! m)))
