#lang racket/base
;; Following a state in time (SICM 1.7, pp. 73 to 76).

(require racket/flonum
         "method-names.rkt" "observed-systems.rkt" "integration-plan.rkt" "run-system.rkt"
         "system/check.rkt" "system/parametric-system.rkt" "system/separable.rkt"
         "system/system.rkt"
         "../calculus/perturbed-value.rkt"
         "../generic/function-check.rkt" "../generic/function.rkt" "../generic/on-demand.rkt"
         "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../error/computed-once.rkt" "../error/progress.rkt"
         "../numeric/equal-steps.rkt"
         "../value/shape.rkt")

(require-on-demand ["precise-run.rkt" advance-precisely follow-precisely]
                   ["linearized-flow.rkt" advance-perturbed flow-derivative variation-maker])

(provide state-advancer evolve linearized-flow
         ;; for single steps and sections
         system-by-shape arity-after)

;; (integrating (who datum takes place follow) (extra ...) (given ...)) : a function of those
;; arguments of follow that come after the first, tolerance -> plan, and the given ones; and of the
;; keywords that integrations have in common, and extra ones.  It prints as (datum).
;; takes : the arguments, in words; place : of the argument before the tolerance
(define-syntax-rule (integrating (who datum takes place follow) (extra ...) (given ...))
  (let ([arity (arity-after follow (+ 1 (length '(given ...))))])
    (make-function
     (with-tolerance-after place who
       (lambda (extra ... #:method [method #f]
                      #:longest-step [longest +inf.0] #:most-steps [most-steps +inf.0]
                      #:precision [bits (ode-precision)] #:progress? [progress? (report-progress)]
                      . arguments)
         (check-count arity datum takes arguments)
         (define (plan-with tolerance)
           (make-plan who tolerance method longest most-steps
                      #:precision bits #:progress? progress?))
         (apply follow plan-with given ... arguments)))
     arity
     datum)))

;; The arity mask of f without its first n arguments
(define (arity-after f n) (arithmetic-shift (procedure-arity-mask f) (- n)))

;; (state-advancer sysder p ...) : state, duration, tolerance, continue -> state
;; continue : state, duration, a length for the next step -> the result
(define (state-advancer derivative-maker . parameters)
  (define system-for (system-by-shape 'state-advancer derivative-maker parameters))
  (define datum (apply call-datum 'state-advancer derivative-maker parameters))
  (define kept (box #f))
  (define variation (once (lambda () (variation-maker derivative-maker (length parameters)))))
  (define (advance plan-with state duration [tolerance #f] [continue state-alone])
    (define p (plan-with tolerance))
    (note-followed derivative-maker parameters state)
    (cond
      [(varied? parameters state duration)
       (check-method-of-displacements 'state-advancer (plan-method p))
       (continue
        (advance-perturbed 'state-advancer (advancing p kept) derivative-maker (variation)
                           parameters state duration)
        duration duration)]
      [else
       (check-real 'state-advancer "duration" duration)
       (define-values (last longest)
         (if (plan-bits p)
             (advance-precisely p (derivative-for derivative-maker parameters) state
                                (real-number duration))
             (advance-flonums p (system-for state) state (->flonum duration))))
       (continue last duration
                 (if (negative? (real-number duration)) (fl- 0.0 longest) longest))]))
  (integrating ('state-advancer datum duration-and-tolerance "duration" advance) () ()))

(define duration-and-tolerance "a state, a duration and perhaps a tolerance")

(define (state-alone state duration next) state)

;; Is one of these being differentiated?
(define (varied? parameters state duration)
  (for*/or ([x (in-list (list* duration state parameters))] [y (in-list (scalars x))])
    (perturbed? y)))

;; Advances another system by the plan p.  The last advancer is kept in the box, for it has the
;; system traced.
(define ((advancing p [kept (box #f)]) maker parameters state duration)
  (define advance (advancer-kept kept maker parameters))
  (call-unwatched
   (lambda ()
     (advance state duration (plan-tolerance p)
      #:method (plan-method p) #:precision (plan-bits p)
      #:longest-step (plan-longest p) #:most-steps (plan-most p)
      #:progress? (plan-progress? p)))))

(define (advancer-kept kept maker parameters)
  (define known (unbox kept))
  (cond [(and known (eq? (caar known) maker) (equal? (cdar known) parameters)) (cdr known)]
        [else
         (define advance (apply state-advancer maker parameters))
         (set-box! kept (cons (cons maker parameters) advance))
         advance]))

;; (linearized-flow sysder p ...) : state, duration, tolerance -> the derivative, by the state
;; and, if that is asked for, the parameters, of the state that is reached
(define (linearized-flow derivative-maker . parameters)
  (check-maker 'linearized-flow derivative-maker parameters)
  (define datum (apply call-datum 'linearized-flow derivative-maker parameters))
  (define check-once
    (by-shape (lambda (state)
                (check-rates-at 'linearized-flow derivative-maker parameters state))))
  (define (derivative plan-with parameters? state duration [tolerance #f])
    (define p (plan-with tolerance))
    (check-method-of-displacements 'linearized-flow (plan-method p))
    (check-once state)
    (note-followed derivative-maker parameters state)
    (flow-derivative (advancing p) derivative-maker parameters state duration parameters?))
  (integrating ('linearized-flow datum duration-and-tolerance "duration" derivative)
               (#:by-parameters? [parameters? #f]) (parameters?)))

;; The message about wrong rates shows the state, and not its displacements.
(define (check-rates-at who maker parameters state)
  (define derivative (derivative-for maker parameters))
  (when (and (tuple? state) (takes-arguments? derivative 1))
    (check-rates who derivative state (derivative state))))

;; -> the state reached and the length of the longest step
(define (advance-flonums p s state duration)
  (define y (state-vector 'state-advancer state))
  (define start (start-time s y))
  (define longest 0.0)
  (define (visit from to interpolant)
    (set! longest (flmax longest (flabs (fl- to from))))
    #t)
  (define last
    (call-for-passage s (lambda (s) (run-reaching p s y start (fl+ start duration) visit))))
  (values last longest))

;; (evolve sysder p ...) : state, monitor, time step, final time, tolerance -> state
(define (evolve derivative-maker . parameters)
  (define system-for (system-by-shape 'evolve derivative-maker parameters))
  (define datum (apply call-datum 'evolve derivative-maker parameters))
  (define (follow plan-with state monitor step final [tolerance #f])
    (define p (plan-with tolerance))
    (note-followed derivative-maker parameters state)
    (define shown (checked-monitor 'evolve monitor))
    (check-positive 'evolve "time step" step
                    "\n  the final time says whether to go forwards or back")
    (check-real 'evolve "final time" final)
    (if (plan-bits p)
        (follow-precisely p (derivative-for derivative-maker parameters) state shown
                          (real-number step) (real-number final))
        (follow-flonums p (system-for state) state shown (->flonum step) (->flonum final))))
  (integrating ('evolve datum evolve-takes "final time" follow) () ()))

(define evolve-takes "a state, a monitor, a time step, a final time and perhaps a tolerance")

(define (follow-flonums p s state monitor step end)
  (check-clock 'evolve state (system-clock? s))
  (define y (state-vector 'evolve state))
  (define start (start-time s y))
  (define (show y) (monitor (system-state s y)))
  (show y)
  (define last
    (call-for-passage
     s (lambda (s)
         (run-reaching p s y start end (sampler start end step (flvector-length y) show)))))
  (unless (fl= start end) (monitor last))
  last)

(define (->flonum x) (real->double-flonum (real-number x)))

;; ---------------------------------------------------------------------------

;; Shows the states at start + step, start + 2 step ... before the end.
(define (sampler start end step n show)
  (define count (step-count (abs (- end start)) step))
  (define signed-step (if (fl< end start) (fl- 0.0 step) step))
  (define out (make-flvector n))
  (define k 1)
  (define (next-time) (fl+ start (fl* (->fl k) signed-step)))
  (lambda (from to interpolant)
    (define (due? t) (and (< k count) (fl>= (fl* signed-step (fl- to t)) 0.0)))
    (define first (next-time))
    (when (due? first)
      (define at (interpolant))
      (define length (fl- to from))
      (let loop ([t first])
        (when (due? t)
          (at (fl/ (fl- t from) length) out)
          (flvector-set! out 0 t)
          (show out)
          (set! k (+ k 1))
          (loop (next-time)))))
    #t))

;; A system is compiled once for an advancer and each shape of state it meets.
(define (system-by-shape who derivative-maker parameters)
  (check-maker who derivative-maker parameters)
  (by-shape
   (lambda (state)
     (begin0 (make-parametric-system who derivative-maker parameters state)
             (note-followed derivative-maker parameters state)))))
