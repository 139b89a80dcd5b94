#lang racket/base
;; One integration of a system by a plan: from a checked start, by a method that suits it, with
;; notes of progress; a failure gives the reason and carries the partial result.

(require racket/flonum
         "integration-plan.rkt" "progress-text.rkt" "partial-result.rkt" "integration-failure.rkt"
         "choose-method.rkt"
         "system/separable.rkt" "system/system.rkt"
         "../error/note.rkt" "../error/progress.rkt"
         "../numeric/ode/integrate.rkt" "../numeric/ode/stepper.rkt")

(provide start-time run-reaching run-system stuck-in)

;; A state without a clock starts at 0.
(define (start-time s y) (if (system-clock? s) (flvector-ref y 0) 0.0))

;; A run whose steps are not kept; a failure carries the state that it reached.
(define (run-reaching p s y start end visit)
  (define t start)
  (define now y)
  (define method #f)
  (define (note from to interpolant)
    (set! t to)
    (visit from to interpolant))
  (define (begun state m)
    (set! now state)
    (set! method m))
  (keeping-so-far
   (lambda () (and method (reached t (system-state s now) real->double-flonum values method)))
   (run-system p s y start end note #:begun begun)))

;; visit : as in integrate; begun : so, too, but also given the method; a failure carries
;; (kept state), given the last state that was good
(define (run-system given s y start end visit [kept values] #:begun [begun void])
  (check-start (plan-who given) s y)
  (define p (suited given s y))
  (define m (plan-method p))
  (check-separable (plan-who p) m s y)
  (define f! (system-right-hand-side s m))
  (define (run note!)
    (define (watched from to interpolant)
      (note-progress note! (progress-text (plan-who p) to end))
      (visit from to interpolant))
    (define-values (t last)
      (integrate (system-method s m) f! y start end
                 #:tolerance (plan-tolerance p)
                 #:longest (plan-longest p)
                 #:limit (plan-most p)
                 #:clock (and (system-clock? s) 0)
                 #:visit (if note! watched visit)
                 #:begun (lambda (y) (begun y m))
                 #:stuck (stuck-in p s kept)))
    (note-left-rest (plan-who p) f! y last (system-clock? s))
    (system-state s last))
  (call-with-progress (plan-progress? p) run))

(define ((stuck-in p s [kept values]) t y why)
  (raise-stuck (plan-who p) s (plan-method p) t y why (kept (system-state s y))))

;; ---------------------------------------------------------------------------
;; A note on motions that begin at rest except for rounding, as a pendulum at π, which is no flonum:
;; they leave an unstable equilibrium at a time and in a direction that rounding decides.

;; y, end : the states at the start and at the end; clock? : is the first number the time?
(define (note-left-rest who f! y end clock?)
  (define from (if clock? 1 0))
  (when (and (left? y end from) (rest-by-rounding? f! y from))
    (note-with-result
     (string-append (symbol->string who)
                    ": the motion begins at rest but for rounding, which decides when it leaves\n"
                    "and where to; to see how an equilibrium is left, begin beside it"))))

(define (left? y end from)
  (for/or ([a (in-flvector y from)] [b (in-flvector end from)])
    (fl> (flabs (fl- b a)) (fl* noticeable (fl+ 1.0 (flabs a))))))

;; Are the rates as small as rounding, but not all 0?  From exact rest the motion would not leave.
(define (rest-by-rounding? f! y from)
  (define slope (rates-at f! y))
  (and (for/and ([v (in-flvector slope from)] [x (in-flvector y from)])
         (fl<= (flabs v) (fl* rounding-of-rates (fl+ 1.0 (flabs x)))))
       (for/or ([v (in-flvector slope from)]) (not (fl= v 0.0)))))

(define noticeable 1e-6)
(define rounding-of-rates 1e-14)
