#lang racket/base
;; Code made of the compiled rates of a system: Taylor coefficients, machine code for whole steps,
;; and the derivatives that implicit methods ask for; and rates whose parameters, inputs after
;; those of the state, have values.
;;
;; All come from the list of instructions of the rates: nothing of the user's is run again, and
;; facts true of the rates when they were compiled are true of these.

(require racket/flonum
         "../../compile/cache.rkt" "../../compile/compile-function.rkt"
         "../../compile/jet/jet-program.rkt" "../../compile/program.rkt"
         "../../compile/derivative-sweep.rkt"
         "../../numeric/flvector.rkt" "../../numeric/machine/straight-code.rkt"
         "../../numeric/ode/right-hand-side.rkt")

(provide expander-of machine-rates-of jacobian-maker fix-parameters)

;; n : how many scalars a state has; ps : the values of the parameters, which become coefficients:
;; to look for these anew takes less than a step or two for each operation, and saves as much at
;; every step.  -> expander (numeric/Taylor/expansion.rkt), or a string, the reason why there is
;; none
(define (expander-of code n ps)
  (define p (compiled-function-program code))
  (define make (and p (program->expansion-maker p n #:constants (flvector->list ps))))
  (cond [(not p) (compiled-function-reason code)]
        [(string? make) make]
        [else (maker->expander make (inputs-with n ps))]))

;; The rates for machine code, kept with their program; or #f.  The inputs after the first n are
;; parameters.
(define (machine-rates-of code n)
  (define p (compiled-function-program code))
  (define (make)
    (and (straight-code? (program-instructions p))
         (make-machine-rates n (- (program-inputs p) n)
                             (program-instructions p) (program-outputs p))))
  (and p (made-of-program p 'machine-rates make)))

;; Room for a state, and the parameters.
(define (inputs-with n ps)
  (define inputs (make-flvector (+ n (flvector-length ps))))
  (for ([p (in-flvector ps)] [k (in-naturals n)]) (flvector-set! inputs k p))
  inputs)

;; run : of a state and parameters -> the same of a state alone
(define (fix-parameters run n ps)
  (define inputs (inputs-with n ps))
  (lambda (y out)
    (flvector-copy! inputs y)
    (run inputs out)))

;; How long the list of derivatives may be: it takes a second to write then, in which differences
;; of the rates do many steps.
(define most-operations 200000)

;; -> (-> (inputs J -> void)), kept with the program; or #f where there are differences only, as
;; where the rates have no code
(define (jacobian-maker code n)
  (define p (compiled-function-program code))
  (define (make)
    (define J (jacobian-program p n #:most most-operations))
    (and J (compiled-program J)))
  (and p (made-of-program p 'jacobian make)))
