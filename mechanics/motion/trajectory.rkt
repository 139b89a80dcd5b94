#lang racket/base
;; Trajectories: a motion as a function of time.
;;
;; Each step of the integration leaves an interpolant; together they give the
;; state at any time from the first to the last, about as well as the steps
;; themselves do.  Trajectories are made by evolve-trajectory.rkt.

(require "partial-result.rkt"
         "event/within-step.rkt"
         "system/check.rkt" "system/system.rkt"
         "../calculus/perturbed-value.rkt"
         "../error/complain.rkt"
         "../generic/notation.rkt"
         "../generic/value-struct.rkt" "../generic/wrong-argument.rkt"
         "../numeric/ode/stepper.rkt")

(provide trajectory? trajectory-states trajectory-so-far
         ;; for those who make them
         trajectory trajectory-steps (struct-out step) (struct-out reading)
         state-within method-shown between? raise-outside
         ;; for those who write them
         step-times)

;; steps : vector of steps, in their order; events : occurrences, in theirs
;; reading : how states are made of steps; method : the name of the method of integration, or a
;; method with a fixed step
(value-struct trajectory (steps events reading method)
  #:datum (lambda (tr) `(trajectory from ,(trajectory-start tr) to ,(trajectory-end tr)))
  #:notation (lambda (tr see)
               (statement (list 0 "trajectory from" (see (trajectory-start tr))
                                "to" (see (trajectory-end tr)))))
  #:property prop:procedure (lambda (tr t) (state-at tr t)))

;; A step from one time to another; inside : for the states between; in flonums the interpolant from
;; the first time to `end`, which is beyond `to` if an event ended the trajectory.
(struct step (from to inside end) #:authentic)

;; exactly : real -> number of the kind of the steps' times; shown : back
;; state   : step time -> state
(struct reading (exactly shown state) #:authentic)

(define (trajectory-start tr) (shown-time tr (first-time tr)))
(define (trajectory-end tr) (shown-time tr (last-time tr)))

(define (first-time tr) (step-from (vector-ref (trajectory-steps tr) 0)))
(define (last-time tr)
  (define steps (trajectory-steps tr))
  (step-to (vector-ref steps (- (vector-length steps) 1))))
(define (shown-time tr t) ((reading-shown (trajectory-reading tr)) t))

(define (trajectory-final-state tr) (state-at tr (last-time tr)))

;; The states at the given times, or at the ends of the steps.
(define (trajectory-states tr [times #f])
  (check-argument 'trajectory-states trajectory? tr a-trajectory)
  (unless (or (not times) (list? times))
    (complain-of-argument 'trajectory-states "a list of times" times))
  (for/list ([t (or times (step-times tr))]) (state-at tr t)))

;; e : an exception that ended an integration, of whatever kind
(define (trajectory-so-far e)
  (check-argument 'trajectory-so-far exn? e "an exception, as a handler of with-handlers gets it")
  (define found (so-far e))
  (if (reached? found) (resting-trajectory found) found))

;; Of no length.
(define (resting-trajectory r)
  (define t (reached-time r))
  (define m (reached-method r))
  (trajectory (vector (step t t (reached-state r) t)) '()
              (reading (reached-exactly r) (reached-shown r) (lambda (s t) (step-inside s)))
              (if (symbol? m) m (method-shown m))))

(define (method-shown m) (if (method-step m) m (method-name m)))

(define a-trajectory "a trajectory, such as evolve-trajectory gives")

(provide-parts trajectory? a-trajectory
  trajectory-start trajectory-end trajectory-final-state trajectory-events trajectory-method)

(define (step-times tr)
  (cons (first-time tr)
        (for/list ([s (in-vector (trajectory-steps tr))]) (step-to s))))

;; ---------------------------------------------------------------------------
;; Reading one

(define (state-at tr t)
  (when (perturbed? t) (raise-differentiated tr))
  (check-real 'trajectory "time" t)
  (define r (trajectory-reading tr))
  (define x (time-within-it tr ((reading-exactly r) (real-number t))))
  (unless x (raise-outside 'trajectory tr t))
  ((reading-state r) (find-step (trajectory-steps tr) x) x))

(define (raise-outside who tr t)
  (complain-showing who "the time is outside the trajectory"
                    "time" t
                    "from" (trajectory-start tr)
                    "to" (trajectory-end tr)))

;; x as a time of the trajectory, or #f.  An end is rounded, to the numbers of the integration
;; and again where it is shown: a time that is rounded to the same is the end.
(define (time-within-it tr x)
  (define shown (reading-shown (trajectory-reading tr)))
  (define-values (first last) (values (first-time tr) (last-time tr)))
  (cond [(between? first x last) x]
        [(equal? (shown x) (shown last)) last]
        [(equal? (shown x) (shown first)) first]
        [else #f]))

;; A derivative by interpolation would be worse than the one that was integrated; and the latter
;; would not show how good the trajectory is.
(define (raise-differentiated tr)
  (complain 'trajectory
            (string-append "a trajectory is not differentiated; its rate of change at a time is "
                           "the state derivative of the state there: "
                           "(compose state-derivative trajectory)"
                           "\n  trajectory: ~a")
            tr))

(define (between? a x b) (or (<= a x b) (>= a x b)))

;; Bisection: the step that holds x.
(define (find-step steps x)
  (let search ([low 0] [high (- (vector-length steps) 1)])
    (define middle (quotient (+ low high) 2))
    (define s (vector-ref steps middle))
    (cond [(or (= low high) (between? (step-from s) x (step-to s))) s]
          [(between? (step-from s) (step-to s) x) (search (+ middle 1) high)]
          [else (search low (- middle 1))])))

(define (state-within s st x)
  (system-state s (row-within s (step-inside st) (step-from st) (step-end st) x)))
