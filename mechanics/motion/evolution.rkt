#lang racket/base
;; Following a state in time (SICM 1.7, pp. 73 to 76).

(require racket/flonum
         "check.rkt" "choice.rkt" "method.rkt" "separable.rkt" "stuck.rkt" "system.rkt"
         "../numeric/ode/integrate.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/structure.rkt")

(provide state-advancer evolve
         ;; for trajectories and single steps
         (struct-out plan) make-plan run-system stuck-in start-time default-tolerance
         system-by-shape made-by)

(define default-tolerance 1e-10)

;; (state-advancer sysder p ...) : state, duration, tolerance, continue -> state
;; continue : state, duration, a length for the next step -> the result
(define (state-advancer derivative-maker . parameters)
  (define system-for (system-by-shape 'state-advancer derivative-maker parameters))
  (define datum (made-by 'state-advancer derivative-maker parameters))
  (define (advance plan-with state duration
                   [tolerance default-tolerance] [continue state-alone])
    (define p (plan-with tolerance))
    (check-real 'state-advancer "duration" duration)
    (define s (system-for state))
    (define y (state-vector 'state-advancer state))
    (define start (start-time s y))
    (define longest 0.0)
    (define (visit from to interpolant)
      (set! longest (flmax longest (flabs (fl- to from))))
      #t)
    (define last
      (run-system p s y start (fl+ start (real->double-flonum duration)) visit))
    (continue last duration (if (negative? duration) (fl- 0.0 longest) longest)))
  (define (advance/keywords #:method [method (ode-integration-method)]
                            #:longest-step [longest +inf.0] #:most-steps [most +inf.0]
                            . arguments)
    (unless (<= 2 (length arguments) 4)
      (raise-arguments (datum) "a state, a duration and perhaps a tolerance" arguments))
    (apply advance (planning 'state-advancer method longest most) arguments))
  (make-function advance/keywords 28 datum))

(define (state-alone state duration next) state)

;; (evolve sysder p ...) : state, monitor, time step, final time, tolerance -> state
(define (evolve derivative-maker . parameters)
  (define system-for (system-by-shape 'evolve derivative-maker parameters))
  (define datum (made-by 'evolve derivative-maker parameters))
  (define (follow plan-with state monitor step final [tolerance default-tolerance])
    (define p (plan-with tolerance))
    (check-monitor 'evolve monitor)
    (check-positive 'evolve "time step" step "\n  the final time says whether to go forwards or back")
    (check-real 'evolve "final time" final)
    (define s (system-for state))
    (check-clock 'evolve state (system-clock? s))
    (define y (state-vector 'evolve state))
    (define start (start-time s y))
    (define end (real->double-flonum final))
    (define (show y) (monitor (system-state s y)))
    (show y)
    (define last
      (run-system p s y start end
                  (sampler start end (real->double-flonum step) (flvector-length y) show)))
    (unless (fl= start end) (monitor last))
    last)
  (define (follow/keywords #:method [method (ode-integration-method)]
                           #:longest-step [longest +inf.0] #:most-steps [most +inf.0]
                           . arguments)
    (unless (<= 4 (length arguments) 5)
      (raise-arguments (datum) evolve-takes arguments))
    (apply follow (planning 'evolve method longest most) arguments))
  (make-function follow/keywords 48 datum))

(define evolve-takes "a state, a monitor, a time step, a final time and perhaps a tolerance")

(define ((made-by who derivative-maker parameters))
  (cons who (map value->datum (cons derivative-maker parameters))))

;; ---------------------------------------------------------------------------
;; How to integrate

;; who : on whose behalf; longest, most : of steps
(struct plan (who tolerance method longest most) #:authentic)

(define (make-plan who tolerance method [longest +inf.0] [most +inf.0])
  (check-tolerance who tolerance)
  (check-longest who longest)
  (check-most who most)
  (plan who (real->double-flonum tolerance) (method-of who method)
        (real->double-flonum longest) most))

(define ((planning who method longest most) tolerance)
  (make-plan who tolerance method longest most))

;; A state without a clock starts at 0.
(define (start-time s y) (if (system-clock? s) (flvector-ref y 0) 0.0))

;; visit : as in integrate; a failure carries (kept state), given the last state that
;; was good
(define (run-system p s y start end visit [kept values])
  (define m (plan-method p))
  (check-separable (plan-who p) m s y)
  (define-values (t last)
    (integrate m (system-right-hand-side s m) y start end
               #:tolerance (plan-tolerance p)
               #:longest (plan-longest p)
               #:limit (plan-most p)
               #:clock (and (system-clock? s) 0)
               #:visit visit
               #:stuck (stuck-in p s kept)))
  (system-state s last))

(define ((stuck-in p s [kept values]) t y why)
  (raise-stuck (plan-who p) s (plan-method p) t y why (kept (system-state s y))))

;; Shows the states at start + step, start + 2 step ... before the end.
(define (sampler start end step n show)
  (define count (sample-count (abs (- end start)) step))
  (define signed-step (if (fl< end start) (fl- 0.0 step) step))
  (define out (make-flvector n))
  (define k 1)
  (define (next-time) (fl+ start (fl* (->fl k) signed-step)))
  (lambda (from to interpolant)
    (define (due?) (and (< k count) (fl>= (fl* signed-step (fl- to (next-time))) 0.0)))
    (when (due?)
      (define at (interpolant))
      (let loop ()
        (when (due?)
          (define t (next-time))
          (at (fl/ (fl- t from) (fl- to from)) out)
          (flvector-set! out 0 t)
          (show out)
          (set! k (+ k 1))
          (loop))))
    #t))

;; How many steps it takes to cover the span; a last one that is tiny is rounding.
(define (sample-count span step)
  (inexact->exact (ceiling (- (/ span step) 1e-6))))

;; A system is compiled once for an advancer and each shape of state it meets.
(define (system-by-shape who derivative-maker parameters)
  (check-maker who derivative-maker parameters)
  (define known '())
  (lambda (state)
    (or (for/first ([s (in-list known)] #:when (same-shape? (system-shape s) state)) s)
        (let ([s (make-parametric-system who derivative-maker parameters state)])
          (set! known (cons s known))
          s))))
