#lang racket/base
;; Motion in numbers of higher precision than flonums, for checking long runs.
;;
;; The same state derivative is followed by extrapolation (numeric/bigfloat), in a
;; few more bits than were asked for, which make up for the rounding on the way.
;; States between the steps are those that a shorter step leads to.

(require math/bigfloat
         "integration-plan.rkt" "progress-text.rkt" "partial-result.rkt" "integration-failure.rkt"
         "system/check.rkt" "system/time-component.rkt" "system/manifold.rkt"
         "../compile/bigfloat-function.rkt"
         "../error/progress.rkt"
         "../numeric/bigfloat/bigfloat-arithmetic.rkt" "../numeric/bigfloat/extrapolation.rkt"
         "../numeric/equal-steps.rkt"
         (only-in "../value/bigfloat.rkt" [bigfloat rounded]))

(provide advance-precisely follow-precisely
         ;; for trajectories
         make-motion motion-start motion-stay motion-follow noting
         exact-time shown-time
         (struct-out stretch) stretch-state stretch-guess)

;; start   : the first time, exact; first : the first state, a vector
;; slope   : state -> its rate, vectors
;; run     : end visit -> time and state reached (numeric/bigfloat/extrapolation.rkt)
;; restart : time state -> the same for a motion from there
;; These compute with more bits, `working`, than states are shown with.
(struct motion (shape clock? bits working start first slope run restart) #:authentic)

;; (kept state) is the value that a failure carries.
(define (make-motion p given state [kept values])
  (define who (plan-who p))
  (define bits (plan-bits p))
  (check-bigfloats who)
  (define derivative (derivative-from who given state))
  (check-derivative who derivative state)
  (define each-step (max (expt 2 (- bits)) (* 1/10 (plan-tolerance p))))
  (define digits (- (bigfloat->flonum (bflog10 (bf each-step)))))
  (define working (+ bits (guard-bits digits)))
  (with-bits working
    (define y (structure->bigfloats state void))
    (define-values (f slope traced?) (bigfloat-function who derivative state))
    (define clock? (constant-rate? slope traced?))
    (define (stuck t y why)
      (define last (shown-state state y bits))
      (raise-cut-short who why (rounded t bits) last (kept last)))
    (define (from t y)
      (make-integrator (if (and clock? (not traced?)) (on-time who f) f)
                       y t (bf each-step) digits #:clock (and clock? 0) #:stuck stuck
                       #:longest (plan-longest p) #:limit (plan-most p)
                       #:shortest (expt 2.0 (- bits))))
    (define start (if clock? (vector-ref y 0) (bf 0)))
    (motion state clock? bits working (exact-value start) y f (from start y) from)))

(define (shown m y) (shown-state (motion-shape m) y (motion-bits m)))

(define (shown-state shape y bits)
  (define rounded
    (with-bits bits
      (for/vector #:length (vector-length y) ([x (in-vector y)]) (bfcopy x))))
  (bigfloats->structure shape rounded))

(define ((on-time who f) y)
  (define slope (f y))
  (unless (bf= (vector-ref slope 0) (bf 1))
    (raise-rate-varies who (exact-value (vector-ref slope 0))))
  slope)

;; ---------------------------------------------------------------------------
;; Following one

;; A step of the integration: the times, exact, and the vectors before and after it.
(struct stretch (from to before after) #:authentic)

;; Goes on to the time `end`; (visit stretch), called after each step, may end it by #f.
;; -> the state reached
(define (motion-follow m end visit)
  (define-values (t y)
    (with-bits (motion-working m)
      ((motion-run m) (bf end)
                      (lambda (from before to after)
                        (visit (stretch (exact-value from) (exact-value to)
                                        before after))))))
  (shown m y))

;; The state at a time within a step: where a motion from its beginning leads to.
(define (stretch-state m s t)
  (define y
    (if (= t (stretch-to s))
        (stretch-after s)
        (with-bits (motion-working m)
          (define run ((motion-restart m) (bf (stretch-from s)) (stretch-before s)))
          (define-values (reached y) (run (bf t) (lambda (from y to z) #t)))
          y)))
  (shown m y))

;; About the state at the fraction theta of a step: a cubic with the states and slopes
;; at its ends.
(define (stretch-guess m s theta)
  (define y
    (with-bits (motion-working m)
      (define h (bf (- (stretch-to s) (stretch-from s))))
      (define-values (before after) (values (stretch-before s) (stretch-after s)))
      (define t (- 1 theta))
      (define weights
        (list (* t t (+ 1 (* 2 theta))) (* theta theta (+ 1 (* 2 t)))
              (* theta t t) (* -1 theta theta t)))
      (define-values (a b c d) (apply values (map bf weights)))
      (for/vector #:length (vector-length before)
                  ([y (in-vector before)] [z (in-vector after)]
                   [v ((motion-slope m) before)] [w ((motion-slope m) after)])
        (bf+ (bf* a y) (bf* b z) (bf* h (bf+ (bf* c v) (bf* d w)))))))
  (shown m y))

;; A time as the integration has it, exact; and as it is shown.
(define (exact-time m t) (exact-value (with-bits (motion-working m) (bf t))))
(define (shown-time m t) (rounded t (motion-bits m)))

;; No motion yet.
(define (motion-stay m)
  (define t (motion-start m))
  (define y (motion-first m))
  (stretch t t y y))

;; ---------------------------------------------------------------------------
;; state-advancer and evolve

;; -> the state reached and the length of the longest step, a flonum
(define (advance-precisely p derivative state duration)
  (define m (make-motion p derivative state))
  (define end (+ (motion-start m) (inexact->exact duration)))
  (define longest 0)
  (define (run note!)
    (define note (noting note! p end))
    (define (visit s)
      (set! longest (max longest (abs (- (stretch-to s) (stretch-from s)))))
      (note s))
    (call-reaching m (lambda (noted) (motion-follow m end (noted visit)))))
  (define last (call-with-progress (plan-progress? p) run))
  (values last (real->double-flonum longest)))

(define ((noting note! p end) s)
  (note-progress note! (progress-text (plan-who p) (stretch-to s) end))
  #t)

;; Each time at which the monitor is called is the end of a step.
(define (follow-precisely p derivative state monitor step end)
  (define m (make-motion p derivative state))
  (check-clock (plan-who p) state (motion-clock? m))
  (define final (inexact->exact end))
  (define times (numbers-between (motion-start m) final (inexact->exact step)))
  (define ((run note!) noted)
    (for/last ([t (in-list times)])
      (define s (motion-follow m t (noted (noting note! p final))))
      (monitor s)
      s))
  (call-with-progress (plan-progress? p) (lambda (note!) (call-reaching m (run note!)))))

;; (body noted), where (noted visit) visits steps that are not kept: exceptions know how far they
;; came.
(define (call-reaching m body)
  (define latest (motion-stay m))
  (define ((noted visit) s)
    (set! latest s)
    (visit s))
  (define (give)
    (reached (stretch-to latest) (shown m (stretch-after latest))
             inexact->exact (lambda (t) (shown-time m t)) 'extrapolation))
  (keeping-so-far give (body noted)))
