#lang racket/base
;; Single steps of integration, for those who watch them or keep step themselves.
;;
;; A step goes as far as it is told to, or less far if the tolerance demands it.
;; What is made of it decides a procedure `continue`: of the state reached, the
;; step taken and the step that seems right next.  Without one these three are the
;; values.

(require racket/flonum
         "check.rkt" "choice.rkt" "evolution.rkt" "method.rkt" "system.rkt"
         "../compile/compile-function.rkt" "../numeric/ode/integrate.rkt"
         "../generic/function.rkt" "../generic/structure.rkt")

(provide free-run-state-advancer ode-advancer advance-beyond)

;; (free-run-state-advancer sysder p ...) : state, step, tolerance, continue -> result
(define (free-run-state-advancer derivative-maker . parameters)
  (define system-for (system-by-shape 'free-run-state-advancer derivative-maker parameters))
  (define (advance state step [tolerance default-tolerance] [continue values]
                   #:method [method (ode-integration-method)])
    (one-step 'free-run-state-advancer (system-for state) state step tolerance method continue))
  (make-function advance 28 (made-by 'free-run-state-advancer derivative-maker parameters)))

;; (ode-advancer derivative tolerance) : state, step, continue -> result
(define (ode-advancer derivative [tolerance default-tolerance] [dimension #f])
  (check-function 'ode-advancer derivative "a state derivative, a function of the state")
  (check-tolerance 'ode-advancer tolerance)
  (define system-for (system-by-shape 'ode-advancer (lambda () derivative) '()))
  (define (advance state step [continue values] #:method [method (ode-integration-method)])
    (define s (system-for state))
    (unless (or (not dimension) (eqv? dimension (system-size s)))
      (raise-arguments-error 'ode-advancer "the state is not of the dimension declared"
                             "state" state
                             "dimension" dimension))
    (one-step 'ode-advancer s state step tolerance method continue))
  (make-function advance 12 (made-by 'ode-advancer derivative (list tolerance))))

;; (advance-beyond sysder p ...) : state, step, tolerance, time, continue -> result
;; The state after the first step that reaches the time or passes it.
(define (advance-beyond derivative-maker . parameters)
  (define system-for (system-by-shape 'advance-beyond derivative-maker parameters))
  (define (run state step tolerance target [continue values]
               #:method [method (ode-integration-method)])
    (check-real 'advance-beyond "time" target)
    (define s (system-for state))
    (check-clock 'advance-beyond state (system-clock? s))
    (define (short? state) (< (* step (clock state)) (* step target)))
    (let loop ([state state] [step step] [taken 0])
      (if (short? state)
          (one-step 'advance-beyond s state step tolerance method
                    (lambda (state taken next) (loop state next taken)))
          (continue state taken step))))
  (make-function run 48 (made-by 'advance-beyond derivative-maker parameters)))

(define (clock state) (vector-ref (structure-elements (adopt state)) 0))

(define (one-step who s state step tolerance method continue)
  (check-real who "step" step)
  (check-tolerance who tolerance)
  (define y (state-vector who state))
  (define m (method-of who method))
  (define start (start-time s y))
  (define h (real->double-flonum step))
  (define-values (now last next)
    (if (fl= h 0.0)
        (values start y h)
        (integrate-step m (system-right-hand-side s m) y start h
                        #:tolerance (real->double-flonum tolerance)
                        #:clock (and (system-clock? s) 0)
                        #:stuck (raise-stuck who s))))
  (define taken (if (fl= now (fl+ start h)) h (fl- now start)))
  (continue (system-state s last) taken next))
