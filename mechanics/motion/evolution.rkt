#lang racket/base
;; Following a state in time (SICM 1.7, pp. 73 to 76).

(require racket/flonum
         "check.rkt" "choice.rkt" "method.rkt" "system.rkt"
         "../numeric/failure.rkt" "../numeric/ode/integrate.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/structure.rkt")

(provide state-advancer evolve
         ;; for trajectories and single steps
         run-system start-time default-tolerance system-by-shape raise-stuck made-by)

(define default-tolerance 1e-10)

;; (state-advancer sysder p ...) : state, duration, tolerance, continue -> state
;; continue : state, duration, a length for the next step -> the result
(define (state-advancer derivative-maker . parameters)
  (define system-for (system-by-shape 'state-advancer derivative-maker parameters))
  (define (advance state duration [tolerance default-tolerance] [continue state-alone]
                   #:method [method (ode-integration-method)])
    (check-real 'state-advancer "duration" duration)
    (check-tolerance 'state-advancer tolerance)
    (define s (system-for state))
    (define y (state-vector 'state-advancer state))
    (define start (start-time s y))
    (define longest 0.0)
    (define (visit from to interpolant)
      (set! longest (flmax longest (flabs (fl- to from))))
      #t)
    (define last
      (run-system 'state-advancer s y start (fl+ start (real->double-flonum duration))
                  tolerance method visit))
    (continue last duration (if (negative? duration) (fl- 0.0 longest) longest)))
  (make-function advance 28 (made-by 'state-advancer derivative-maker parameters)))

(define (state-alone state duration next) state)

;; (evolve sysder p ...) : state, monitor, time step, final time, tolerance -> state
(define (evolve derivative-maker . parameters)
  (define system-for (system-by-shape 'evolve derivative-maker parameters))
  (define (follow state monitor step final [tolerance default-tolerance]
                  #:method [method (ode-integration-method)])
    (check-monitor 'evolve monitor)
    (check-positive 'evolve "time step" step)
    (check-real 'evolve "final time" final)
    (check-tolerance 'evolve tolerance)
    (define s (system-for state))
    (check-clock 'evolve state (system-clock? s))
    (define y (state-vector 'evolve state))
    (define start (start-time s y))
    (define end (real->double-flonum final))
    (define (show y) (monitor (system-state s y)))
    (show y)
    (define last
      (run-system 'evolve s y start end tolerance method
                  (sampler start end (real->double-flonum step) (flvector-length y) show)))
    (unless (fl= start end) (monitor last))
    last)
  (make-function follow 48 (made-by 'evolve derivative-maker parameters)))

(define ((made-by who derivative-maker parameters))
  (cons who (map value->datum (cons derivative-maker parameters))))

;; ---------------------------------------------------------------------------

;; A state without a clock starts at 0.
(define (start-time s y) (if (system-clock? s) (flvector-ref y 0) 0.0))

;; A failure carries (kept state), given the last state that was good.
(define (run-system who s y start end tolerance method visit [kept values])
  (define m (method-of who method))
  (define-values (t last)
    (integrate m (system-right-hand-side s m) y start end
               #:tolerance (real->double-flonum tolerance)
               #:clock (and (system-clock? s) 0)
               #:visit visit
               #:stuck (raise-stuck who s kept)
               #:name who))
  (system-state s last))

(define ((raise-stuck who s [kept values]) t y)
  (define state (system-state s y))
  (raise-singular who "the motion cannot be followed any further" (kept state)
                  "time" t
                  "last state" state))

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
