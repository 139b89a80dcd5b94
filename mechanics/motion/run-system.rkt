#lang racket/base
;; One integration of a system by a plan: from a checked start, by a method that suits it, with
;; notes of progress; a failure gives the reason and carries the partial result.

(require racket/flonum
         "integration-plan.rkt" "rest-by-rounding.rkt" "sample-times.rkt" "partial-result.rkt"
         "integration-failure.rkt" "choose-method.rkt"
         "system/separable.rkt" "system/system.rkt"
         "../error/progress.rkt"
         "../numeric/ode/integrate.rkt")

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
