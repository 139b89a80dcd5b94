#lang racket/base
;; Maps made of motions (SICM 3.6): from where a motion crosses a surface in phase space to where
;; it crosses it next, and from a state to the one a period later.
;;
;; The crossing is found along the interpolants of the integration.  Its derivatives by the start
;; x need no interpolant: with T the duration and g the event's function, zero there, the motion
;; from x + ε dx to T is advanced by the δ that one step of Newton's method for g = 0 finds in the
;; arithmetic of perturbed values, which is right to first order in each ε.

(require racket/flonum
         (only-in racket/list remove-duplicates)
         "map/period-check.rkt"
         "../calculus/derivative.rkt" "../calculus/perturbed-value.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/hint.rkt"
         "../error/computed-once.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/define-plain.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/printed-function.rkt"
         "../generic/wrong-argument.rkt"
         "../lagrangian/function-of-momenta.rkt"
         "../motion/system/check.rkt" "../motion/event/event.rkt" "../motion/event/event-watch.rkt"
         "../motion/evolution.rkt" "../motion/integration-plan.rkt" "../motion/run-system.rkt"
         "../motion/system/system.rkt"
         "../numeric/flvector.rkt" "../search/implicit-root.rkt"
         "../value/shape.rkt")

(provide Poincare-map stroboscopic-map)

;; derivative : state -> its rate
;; -> a function from a state to the state at the next event
(define-plain (Poincare-map derivative event
                            #:tolerance [tolerance 1e-12]
                            #:longest-step [longest +inf.0]
                            #:most-steps [most 100000])
  (check-section derivative event)
  (define p (make-plan 'Poincare-map tolerance #f longest +inf.0 #:precision #f #:progress? #f))
  (check-most 'Poincare-map most)
  (define finder-for (finders derivative event p most))
  (define advance (once (lambda () (state-advancer (lambda () derivative)))))
  (printed-function (Poincare-map derivative event) (state)
    (if (ormap perturbed? (scalars state))
        (varied-crossing derivative event (advance) tolerance finder-for state)
        (let-values ([(t next) ((finder-for state) state)]) next))))

(define (check-section derivative e)
  (check-state-derivative 'Poincare-map derivative)
  (check-argument 'Poincare-map event? e
                  (string-append "an event; (event f #:direction 'rising) makes one of a "
                                 "function of the state")))

(define (check-state-derivative who f)
  (unless (and (procedure? f) (accepts? f 1))
    (complain who "expected a state derivative, a function of the state; given ~a~a"
              (describe-function f) (derivative-hint f)))
  (when (of-momenta? f)
    (complain who "expected a state derivative, a function of the state\n  given: ~a\n  ~a"
              (describe-with-value f) (state-derivative-hint f))))

(define (derivative-hint f)
  (if (and (procedure? f) (accepts? f 0))
      (format "\n  it makes one: (~a)" (value->text f))
      (quoted-name-hint f)))

;; ---------------------------------------------------------------------------
;; Where the motion crosses next

;; -> a function from a state to a finder, compiled once for each shape of state; a finder
;; takes a state to the duration until the event and the state there.
(define (finders derivative e p most)
  (define system-for (system-by-shape 'Poincare-map (lambda () derivative) '()))
  (by-shape
   (lambda (state)
     (define s (system-for state))
     (finder s e p most
             (watches-for 'Poincare-map (list e) state (system-size s) (plan-tolerance p))))))

(define ((finder s e p most new-watch) state)
  (define y (state-vector 'Poincare-map state))
  (define start (start-time s y))
  (define watch (new-watch))
  (define steps 0)
  (define found #f)
  (define there (make-flvector (flvector-length y)))
  (define ((at-start at) c)
    (at (crossing-at c) there)
    (near-start? there y (plan-tolerance p)))
  (define (visit from to interpolant)
    (set! steps (+ steps 1))
    (define at (interpolant))
    (define c (first-crossing (watch at) (and (= steps 1) (at-start at))))
    (when c
      (when (undefined? (crossing-event c))
        (raise-undefined e from state #f 'Poincare-map))
      (set! found (fl+ (fl- from start) (fl* (crossing-at c) (fl- to from))))
      (at (crossing-at c) there))
    (and (not c) (< steps most) (fl< (flabs (fl- to start)) longest-wait)))
  (call-for-passage s (lambda (s) (run-system p s y start +inf.0 visit)))
  (unless found (raise-never (system-derivative s) e state steps))
  (when (system-clock? s) (flvector-set! there 0 (fl+ start found)))
  (values found (system-state s there)))

;; The steps of a motion that comes to rest grow without bound; it is given up after this time.
(define longest-wait 1e100)

;; The first crossing that is not the start: by rounding, a start on the surface may seem to cross
;; it.  start? : crossing -> is it at the start?; #f after the first step
(define (first-crossing found start?)
  (for/first ([c (in-list found)] #:unless (and start? (start? c))) c))

;; Is the state as near to the start as the error of the integration?
(define (near-start? there y tolerance)
  (short? (difference there y) y (fl* 10.0 tolerance)))

(define (raise-never derivative e state steps)
  (define what
    (if (rests? derivative state)
        "the motion rests where it starts, and does not come to the surface"
        (string-append "the motion has not come back to the surface"
                       "\n  an angle that goes round passes a value once; its sine "
                       "comes back to it each turn")))
  (raise-not-convergent 'Poincare-map what state #f #:show? #f
                        "event" e "start" state "steps" steps))

(define (rests? derivative state)
  (define rates (map comparand (scalars (derivative state))))
  (andmap (lambda (x) (and (number? x) (zero? x)))
          (if (timed-state? derivative state) (cdr rates) rates)))

;; ---------------------------------------------------------------------------
;; Derivatives by the start

(define (varied-crossing f e advance tolerance finder-for state)
  (define start (plain state))
  (define-values (duration there) ((finder-for start) start))
  (define tags (for/list ([x (in-list (scalars state))] #:when (perturbed? x)) (perturbed-tag x)))
  (define different (reverse (remove-duplicates tags eqv?)))
  (for/fold ([x (advance state duration tolerance)]) ([tag (in-list different)])
    (define-values (g rate) (value-and-derivative-along (event-f e) x (f x)))
    (advance x (g:- (g:/ g rate)) tolerance)))

;; ---------------------------------------------------------------------------
;; A period later

;; -> a function from a state to the state a period later; a negative period leads back
(define-plain (stroboscopic-map derivative period #:tolerance [tolerance 1e-12])
  (define who 'stroboscopic-map)
  (check-comes-first who (and (not (pointwise? derivative)) (pointwise? period))
                     "state derivative" "period")
  (check-state-derivative who derivative)
  (check-duration who period)
  (check-tolerance who tolerance)
  (define advance (state-advancer (lambda () derivative)))
  (define checked? #f)
  (define (next state)
    (unless checked?
      (unless (ormap perturbed? (scalars state)) (check-derivative who derivative state))
      (check-period who derivative state period)
      (set! checked? #t))
    (advance state period tolerance))
  (printed-function (stroboscopic-map derivative period) (state)
    (next state)))
