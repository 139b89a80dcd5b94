#lang racket/base
;; Is a motion regular or chaotic?  Three answers, from displacements v of it that follow the
;; equations of variations, v' = Df v.
;;
;; A displacement of a chaotic motion grows without end: so its direction w = v/|v| and the
;; logarithm of its length are followed instead, with the rate a at which it grows,
;;
;;     a = w·(Df w)/w·w,    w' = Df w − a w,    (log |v|)' = a.
;;
;; FLI, the fast Lyapunov indicator (Froeschlé, Lega and Gonczi 1997), is log |v| at the end, here
;; to base 10: as log t where the motion is regular, as t where it is chaotic.  MEGNO (Cincotta and
;; Simó 2000) is the mean over the time T of Y(t) = 2/t ∫ a s ds.  Exchanging the integrals,
;;
;;     mean Y = 2/T (log T ∫ a s ds − ∫ a s log s ds),
;;
;; which tends to 2 where the motion is quasiperiodic, to λT/2 where it has an exponent λ.  SALI,
;; the smaller alignment index (Skokos 2001), is the lesser of |w − u| and |w + u| for two
;; directions: it stays where the motion is regular and falls as an exponential where it is chaotic.
;;
;; All of these join the state, and are integrated with it as one motion, traced once.

(require "map-indicator.rkt" "map/period-check.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/elementary.rkt" "../generic/function-check.rkt"
         "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         "../motion/evolution.rkt" "../motion/linearized-flow.rkt" "../motion/observed-systems.rkt"
         "../motion/system/check.rkt"
         "../value/shape.rkt" (only-in "../value/structure.rkt" structure->list))

(provide chaos-indicator
         ;; for many motions
         check-kind check-no-tolerance usual-tolerance
         watched-derivative watched-start indicator-of indicator-method)

(define who 'chaos-indicator)

;; f : state derivative -> the indicator of the motion from the state for the duration
;; or a map of the plane -> that of the orbit from a point for so many steps
(define-plain (chaos-indicator f state duration
                               #:indicator [kind 'FLI] #:tolerance [tolerance #f])
  (check-kind who kind)
  (cond [(takes-arguments? f 4)
         (check-no-tolerance who tolerance)
         (map-indicator who f state duration kind)]
        [else (motion-indicator f state duration kind (or tolerance usual-tolerance))]))

(define usual-tolerance 1e-10)

(define (check-no-tolerance who tolerance)
  (when tolerance
    (complain who "a tolerance is for motions; the steps of a map have none\n  given: ~a"
              (value->text tolerance))))

(define (motion-indicator f state duration kind tolerance)
  (check-derivative who f state)
  (check-positive who "duration" duration)
  (check-tolerance who tolerance)
  (note-followed f '() state)
  (define advance (state-advancer (lambda () (watched-derivative kind f))))
  (define (followed)
    (advance (watched-start kind f state) duration tolerance #:method indicator-method))
  (indicator-of kind (call-unwatched (lambda () (call-for-state who followed)))))

;; Quotients and logarithms make Taylor's method take twice to four times as long.
(define indicator-method 'Dormand-Prince-853)

(define (check-kind who kind)
  (check-argument who (lambda (k) (memq k '(FLI MEGNO SALI))) kind "'FLI, 'MEGNO or 'SALI"))

;; ---------------------------------------------------------------------------
;; The motion with the values watched: (up state w more ...)

(define (watched-start kind f state)
  (define from (if (timed-state? f state) 1 0))
  (define n (- (shape-length state) from))
  (define (direction part)
    (define size (sqrt (for/sum ([k (in-range n)]) (expt (part k) 2.0))))
    (scalars->structure state (lambda (k) (if (< k from) 0 (/ (part (- k from)) size)))))
  (define (rising k) (+ 1.0 (/ k 3.0)))
  (define w (direction rising))
  (define (alternating k) (* (if (even? k) 1.0 -1.0) (rising (- n k 1))))
  (case kind
    [(FLI) (up state w 0.0)]
    [(MEGNO) (up state w (up 0.0 0.0 0.0))]
    [(SALI) (up state w (direction alternating))]))

;; -> the derivative of (up state w more): the logarithm of the length; time, ∫ a s ds and
;; ∫ a s log s ds; or another direction
(define ((watched-derivative kind f) all)
  (define parts (structure->list all))
  (define-values (state more) (values (car parts) (caddr parts)))
  (define-values (slope turning growth) (turned f state (cadr parts)))
  (up slope turning
      (case kind
        [(FLI) growth]
        [(MEGNO) (time-moments (car (structure->list more)) growth)]
        [(SALI) (let-values ([(_ other-turning __) (turned f state more)]) other-turning)])))

;; -> f(state), the rate of the direction w, and the rate a
(define (turned f state w)
  (define-values (slope change) (value-and-derivative-along f state w))
  (define growth (g:/ (product w change) (product w w)))
  (values slope (g:- change (g:* growth w)) growth))

(define (product v w)
  (apply g:+ (for/list ([a (in-list (scalars v))] [b (in-list (scalars w))]) (g:* a b))))

;; t log t is 0 at 0.
(define (time-moments t a)
  (define at (g:* a t))
  (up 1.0 at (g:* at (g:* 0.5 (g:log (g:+ (g:* t t) 1e-300))))))

;; ---------------------------------------------------------------------------
;; The indicator at the end.  No decision is taken, so that this is compiled.

(define (indicator-of kind all)
  (define parts (structure->list all))
  (define-values (w more) (values (cadr parts) (caddr parts)))
  (case kind
    [(FLI) (g:/ more (log 10.0))]
    [(MEGNO)
     (define-values (t first second) (apply values (structure->list more)))
     (g:* (g:/ 2 t) (g:- (g:* (g:log t) first) second))]
    [(SALI) (lesser-distance (unit w) (unit more))]))

(define (unit v) (g:/ v (g:sqrt (product v v))))

;; The lesser of |w − u| and |w + u|, whose squares have the sum 4.
(define (lesser-distance w u)
  (define (square v) (product v v))
  (define both (g:* (square (g:- w u)) (square (g:+ w u))))
  (g:sqrt (g:/ both (g:+ 2 (g:sqrt (g:abs (g:- 4 both)))))))
