#lang racket/base
;; A state derivative ready for integration: compiled, its first value checked.
;;
;; The parameters of a system become inputs of the compiled code beside the
;; state, so that another set of numbers uses the same code.  If the system
;; decides something by a parameter, it is compiled for that one.

(require racket/flonum
         "../compile/compile-function.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/structure.rkt"
         "../value/shape.rkt")

(provide (struct-out system) make-system make-parametric-system check-maker
         system-state system-size state-vector)

;; shape : a state; clock? : is its first scalar the time, with derivative 1?
;; make-slope! : -> (y dy -> void), for one integration
(struct system (shape clock? make-slope!) #:authentic)

(define (system-state s y) (flvector->structure (system-shape s) y))

(define (system-size s) (shape-length (system-shape s)))

(define (state-vector who state)
  (structure->flvector state (lambda (x) (raise-not-a-number who state x))))

;; derivative : state -> state
(define (make-system who derivative state)
  (define clock? (check-derivative who derivative state))
  (define code (compile-function derivative state #:name who))
  (system state clock? (lambda () (compiled-function-run code))))

;; derivative-maker : parameters -> derivative
(define (make-parametric-system who derivative-maker parameters state)
  (define (derivative-for ps)
    (if (takes-state-only? derivative-maker ps) derivative-maker (apply derivative-maker ps)))
  (define (fixed) (make-system who (derivative-for parameters) state))
  (cond
    [(or (null? parameters) (not (andmap real? parameters))) (fixed)]
    [else
     (define (f s) ((derivative-for (structure->list (cadr-of s))) (car-of s)))
     (define clock? (check-derivative who (derivative-for parameters) state))
     (define code (compile-function f (up state (apply up parameters)) #:name who))
     (if (compiled-function-reason code)
         (fixed)
         (system state clock? (slope-maker code (state-vector who (apply up parameters)))))]))

(define (car-of s) (vector-ref (structure-elements s) 0))
(define (cadr-of s) (vector-ref (structure-elements s) 1))
(define (structure->list s) (vector->list (structure-elements s)))

;; The state derivative itself may stand for the procedure of no parameters that
;; makes it.
(define (takes-state-only? f ps)
  (and (null? ps) (accepts? f 1) (not (accepts? f 0))))

(define ((slope-maker code ps))
  (define n (compiled-function-outputs code))
  (define input (make-flvector (compiled-function-inputs code)))
  (for ([p (in-flvector ps)] [k (in-naturals n)]) (flvector-set! input k p))
  (define run (compiled-function-run code))
  (lambda (y dy)
    (let loop ([i 0])
      (when (< i n)
        (flvector-set! input i (flvector-ref y i))
        (loop (+ i 1))))
    (run input dy)))

;; ---------------------------------------------------------------------------
;; Checks

;; -> is the first scalar of the state a clock?
(define (check-derivative who derivative state)
  (define y (state-vector who state))
  (check-function-of-state who derivative)
  (define slope (derivative (flvector->structure state y)))
  (unless (same-shape? slope state)
    (raise-arguments-error
     who "the state derivative is of another shape than the state"
     "state" state
     "derivative" slope))
  (eqv? 1 (car (scalars slope))))

(define (check-function-of-state who derivative)
  (unless (and (procedure? derivative) (accepts? derivative 1))
    (complain "~a: expected a state derivative, a function of the state\n  given: ~a~a"
              who (describe-with-value derivative)
              (if (procedure? derivative)
                  (format ", which takes ~a\n  parameters are supplied first: (~a ...)"
                          (arity->text derivative) (value->text derivative))
                  ""))))

;; maker : what is to make a state derivative of that many parameters
(define (check-maker who maker parameters)
  (unless (procedure? maker)
    (complain "~a: expected a procedure that makes a state derivative\n  given: ~a"
              who (describe-with-value maker)))
  (unless (or (accepts? maker (length parameters)) (takes-state-only? maker parameters))
    (complain
     (string-append
      "~a: expected as many parameters as the maker of the state derivative takes"
      "\n  maker: ~a, which takes ~a\n  parameters: ~a~a")
     who (describe-with-value maker) (arity->text maker)
     (if (null? parameters) "none" (value->text parameters))
     (if (takes-state-only? maker '())
         "\n  a state derivative itself is given without parameters"
         ""))))

(define (raise-not-a-number who state x)
  (complain "~a: expected a state of real numbers; ~a is none\n  state: ~a~a"
            who (describe-with-value x) (value->text state)
            (if (pair? x) "\n  a list is not a tuple; use (up x y ...)" "")))

(define (complain text . parts)
  (raise (exn:fail:contract (apply format text parts) (current-continuation-marks))))
