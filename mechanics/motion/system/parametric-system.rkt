#lang racket/base
;; Systems with parameters.
;;
;; The parameters of a system that are numbers, or tuples of numbers, become inputs of
;; the compiled code beside the state, so that other numbers use the same code.  If the system
;; decides something by a parameter, it is compiled for that one.

(require "check.rkt" "clock.rkt" "make-system.rkt" "manifold.rkt" "rates-code.rkt" "system.rkt"
         "../../compile/compile-function.rkt"
         "../../error/computed-once.rkt"
         "../../generic/up-down.rkt"
         "../../value/shape.rkt" (only-in "../../value/structure.rkt" ref structure->list))

(provide make-parametric-system derivative-for)

;; derivative-maker : parameters -> derivative
(define (make-parametric-system who derivative-maker parameters state)
  (define derivative (derivative-for derivative-maker parameters))
  (or (and (ormap numeric? parameters)
           (not (manifold-derivative? derivative))
           (system-of-parameters who derivative derivative-maker parameters state))
      (make-system who derivative state)))

;; #f if the system takes a decision.
(define (system-of-parameters who derivative derivative-maker parameters state)
  (define slope (check-derivative who derivative state))
  (define inputs (apply up (filter numeric? parameters)))
  (define ps (structure->flvector inputs values))
  (define example (up state inputs))
  (define n (shape-length state))
  (define (f s)
    (define all (with-numbers parameters (structure->list (ref s 1))))
    ((derivative-for derivative-maker all) (ref s 0)))
  ;; The parameters are as they were given: an exact 2 may count or choose.
  (define (rates-at v) (derivative (flvector->structure state v)))
  (define code
    (compile-traced f example #:name who #:value-at rates-at #:varying n #:value slope))
  (define jacobian (once (lambda () (jacobian-maker code n))))
  (define (with-parameters run) (fix-parameters run n ps))
  (and code
       (system state (clock-first? code) derivative
               (lambda () (with-parameters (compiled-function-runner code)))
               (lambda () (let ([make (jacobian)]) (and make (with-parameters (make)))))
               (compiled-function-operations code)
               (once (lambda () (expander-of code n ps)))
               (once (lambda () (machine-rates-of code n)))
               ps
               #f (box '()) (box #f) #f)))

;; Masses may be given as a tuple.
(define (numeric? parameter) (andmap real? (scalars parameter)))

;; The parameters with these in place of the numeric ones.
(define (with-numbers parameters numbers)
  (cond [(null? parameters) '()]
        [(numeric? (car parameters))
         (cons (car numbers) (with-numbers (cdr parameters) (cdr numbers)))]
        [else (cons (car parameters) (with-numbers (cdr parameters) numbers))]))

(define (derivative-for derivative-maker ps)
  (if (takes-state-only? derivative-maker ps) derivative-maker (apply derivative-maker ps)))
