#lang racket/base
;; Code made of the compiled rates of a system: Taylor coefficients, machine code for whole steps,
;; and the derivatives that implicit methods ask for; and rates whose parameters, inputs after
;; those of the state, have values.
;;
;; All come from the list of instructions of the rates: nothing of the user's is run again, and
;; what was true of the rates when they were compiled is true of these.

(require racket/flonum
         racket/unsafe/ops
         "../../compile/cache.rkt" "../../compile/compile-function.rkt"
         "../../compile/jet/jet-program.rkt" "../../compile/program.rkt"
         "../../compile/tangent-program.rkt"
         "../../numeric/flvector.rkt" "../../numeric/machine/straight-code.rkt"
         "../../numeric/ode/right-hand-side.rkt")

(provide expander-of program-expander machine-rates-of program-machine-rates
         jacobian-maker rates-jacobian fix-parameters)

;; n : how many scalars a state has; ps : the values of the parameters
(define (expander-of code n ps)
  (define p (compiled-function-program code))
  (if p (program-expander p n ps) (compiled-function-reason code)))

;; The same of a program.  The parameters become coefficients: to look for these anew takes less
;; than a step or two for each operation, and saves as much at every step.
(define (program-expander p n ps)
  (define make (program->expansion-maker p n #:constants (flvector->list ps)))
  (if (string? make) make (maker->expander make (inputs-with n ps))))

;; The rates for machine code, kept with their program; or #f
(define (machine-rates-of code n)
  (define p (compiled-function-program code))
  (and p (made-of-program p 'machine-rates (lambda () (program-machine-rates p n)))))

;; The inputs after the first n are parameters.
(define (program-machine-rates p n)
  (and (straight-code? (program-instructions p))
       (make-machine-rates n (- (program-inputs p) n)
                           (program-instructions p) (program-outputs p))))

;; Room for a state, and the parameters.
(define (inputs-with n ps)
  (define inputs (make-flvector (+ n (flvector-length ps))))
  (for ([p (in-flvector ps)] [k (in-naturals n)]) (flvector-set! inputs k p))
  inputs)

;; run : of a state and parameters -> the same of a state alone
(define (fix-parameters run n ps)
  (define inputs (inputs-with n ps))
  (lambda (y out)
    (let loop ([i 0])
      (when (unsafe-fx< i n)
        (unsafe-flvector-set! inputs i (unsafe-flvector-ref y i))
        (loop (unsafe-fx+ i 1))))
    (run inputs out)))

;; How long the list of derivatives may be: it takes a second to write then, in which differences
;; of the rates do many steps.
(define most-operations 200000)

;; p : program of the rates -> that of their derivatives by the n scalars of a state; or #f where
;; there are differences only
(define (rates-jacobian p n) (jacobian-program p n #:most most-operations))

;; -> (-> (inputs J -> void)); or #f, as well where the rates have no code
(define (jacobian-maker code n)
  (define p (compiled-function-program code))
  (define J (and p (rates-jacobian p n)))
  (and J (compiled-program J)))
