#lang racket/base
;; Single steps of integration, for programs that watch them or choose their lengths.
;;
;; A step has the given length, or a shorter one if the tolerance demands it.  The result is that
;; of a procedure `continue`, given the state reached, the length of the step and the length that
;; seems right for the next one; by default these three values.

(require racket/flonum
         "method-names.rkt" "evolution.rkt" "integration-plan.rkt" "run-system.rkt"
         "choose-method.rkt"
         "system/check.rkt" "system/separable.rkt" "system/system.rkt"
         "../compile/compile-function.rkt"
         "../error/complain.rkt"
         "../generic/function.rkt" "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../numeric/ode/integrate.rkt")

(provide free-run-state-advancer ode-advancer advance-beyond)

;; (free-run-state-advancer sysder p ...) : state, step, tolerance, continue -> result
(define (free-run-state-advancer derivative-maker . parameters)
  (define who 'free-run-state-advancer)
  (define system-for (system-by-shape who derivative-maker parameters))
  (define (advance method state step [tolerance default-tolerance] [continue values])
    (one-step (make-plan who tolerance method) (system-for state) state step continue))
  (stepping who (apply call-datum who derivative-maker parameters)
            "a state, a step and perhaps a tolerance" advance))

;; (ode-advancer derivative tolerance) : state, step, continue -> result
(define (ode-advancer derivative [tolerance default-tolerance] [dimension #f])
  (check-function 'ode-advancer derivative "a state derivative, a function of the state")
  (check-tolerance 'ode-advancer tolerance)
  (define system-for (system-by-shape 'ode-advancer (lambda () derivative) '()))
  (define (advance method state step [continue values])
    (define s (system-for state))
    (unless (or (not dimension) (eqv? dimension (system-size s)))
      (complain-showing 'ode-advancer "the state is not of the dimension declared"
                        "state" state
                        "dimension" dimension))
    (one-step (make-plan 'ode-advancer tolerance method) s state step continue))
  (stepping 'ode-advancer (call-datum 'ode-advancer derivative tolerance)
            "a state and a step" advance))

;; (advance-beyond sysder p ...) : state, step, tolerance, time, continue -> result
;; The state after the first step that reaches the time or passes it.
(define (advance-beyond derivative-maker . parameters)
  (define system-for (system-by-shape 'advance-beyond derivative-maker parameters))
  (define (advance method state step tolerance target [continue values])
    (define p (make-plan 'advance-beyond tolerance method))
    (check-real 'advance-beyond "time" target)
    (define s (system-for state))
    (check-clock 'advance-beyond state (system-clock? s))
    (define (short? state) (< (* step (structure-ref state 0)) (* step target)))
    (let loop ([state state] [step step] [taken 0])
      (if (short? state)
          (one-step p s state step (lambda (state taken next) (loop state next taken)))
          (continue state taken step))))
  (stepping 'advance-beyond (apply call-datum 'advance-beyond derivative-maker parameters)
            "a state, a step, a tolerance and a time" advance))

;; (advance method argument ...) as a function of the arguments, with the method as a keyword;
;; takes : these arguments, in words
(define (stepping who datum takes advance)
  (define arity (arity-after advance 1))
  (define (advance/keywords #:method [method (ode-integration-method)] . arguments)
    (check-count arity datum takes arguments)
    (apply advance method arguments))
  (make-function (procedure-rename advance/keywords who) arity datum))

(define (one-step given s state step continue)
  (define who (plan-who given))
  (check-real who "step" step)
  (define y (state-vector who state))
  (check-start who s y)
  (define h (real->double-flonum step))
  (define start (start-time s y))
  (define-values (now last next)
    (call-for-passage s (lambda (s) (step-from given s y start h))))
  (define taken (if (fl= now (fl+ start h)) h (fl- now start)))
  (continue (system-state s last) taken next))

(define (step-from given s y start h)
  (define p (suited given s y))
  (define m (plan-method p))
  (check-separable (plan-who p) m s y)
  (if (fl= h 0.0)
      (values start y h)
      (integrate-step (system-method s m) (system-right-hand-side s m) y start h
                      #:tolerance (plan-tolerance p)
                      #:clock (and (system-clock? s) 0)
                      #:stuck (stuck-in p s))))
