#lang racket/base
;; Systems with parameters.
;;
;; The parameters of a system that are numbers, or tuples of numbers, become inputs of
;; the compiled code beside the state, so that other numbers use the same code.  A system that
;; decides something by a parameter is compiled for its value.

(require "check.rkt" "make-system.rkt" "manifold.rkt" "rates-code.rkt"
         "../../compile/compile-function.rkt"
         "../../generic/up-down.rkt"
         "../../value/shape.rkt" (only-in "../../value/structure.rkt" ref structure->list))

(provide make-parametric-system derivative-for with-numbers)

;; derivative-maker : parameters -> derivative
(define (make-parametric-system who derivative-maker parameters state)
  (define derivative (derivative-for derivative-maker parameters))
  (or (and (ormap numeric? parameters)
           (not (manifold-derivative? derivative))
           (system-of-parameters who derivative derivative-maker parameters state))
      (make-system who derivative state)))

;; -> system, or #f if the system decides something by a parameter
(define (system-of-parameters who derivative derivative-maker parameters state)
  (define slope (check-derivative who derivative state))
  (define inputs (apply up (filter numeric? parameters)))
  (define ps (structure->flvector inputs values))
  (define example (up state inputs))
  (define n (shape-length state))
  (define (f s)
    (define all (with-numbers numeric? parameters (structure->list (ref s 1))))
    ((derivative-for derivative-maker all) (ref s 0)))
  ;; The parameters are as they were given: an exact 2 may count or choose.
  (define (rates-at v) (derivative (flvector->structure state v)))
  (define code
    (compile-traced f example #:name who #:value-at rates-at #:varying n #:value slope))
  (define (with-parameters run) (fix-parameters run n ps))
  (and code (system-of-code state derivative code with-parameters with-parameters ps #f)))

;; The parameters with the given numbers in place of those that vary.
(define (with-numbers varies? parameters numbers)
  (cond [(null? parameters) '()]
        [(varies? (car parameters))
         (cons (car numbers) (with-numbers varies? (cdr parameters) (cdr numbers)))]
        [else (cons (car parameters) (with-numbers varies? (cdr parameters) numbers))]))

(define (derivative-for derivative-maker ps)
  (if (takes-state-only? derivative-maker ps) derivative-maker (apply derivative-maker ps)))
