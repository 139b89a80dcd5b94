#lang racket/base
;; Action and angle of systems with one coordinate, by integration (SICM 5.8 and 6.1).
;;
;; The motion through a state is followed until it closes: it encloses 2π I = ∮ p dq, takes the
;; period T, and turns at ω = 2π/T = dE/dI.  The angle is ω times the time since the motion passed
;; a given coordinate, forwards.  A coordinate that is an angle may close by a turn.

(require "momentum-of-action.rkt"
         "../error/complain.rkt" "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/elementary.rkt" "../generic/function.rkt" "../generic/on-demand.rkt"
         "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamilton-equations.rkt"
         "../hamiltonian/Hamiltonian.rkt"
         "../lagrangian/local-tuple.rkt"
         "../numeric/constants.rkt")

(require-on-demand
 ["../motion/trajectory.rkt" evolve-trajectory trajectory-events trajectory-final-state]
 ["../motion/event.rkt" event occurrence-state occurrence-time])

(provide action-of-orbit frequency-of-orbit state->action-angle action-angle->state)

;; ---------------------------------------------------------------------------
;; Orbits

(struct orbit (period action) #:authentic)

;; turn : of a coordinate that is an angle, or #f; longest : the time after which to give up
(define-plain (action-of-orbit H state #:turn [turn #f] #:tolerance [tolerance 1e-11]
                               #:longest [longest 1e4])
  (orbit-action (closed-orbit 'action-of-orbit H state turn tolerance longest)))

(define-plain (frequency-of-orbit H state #:turn [turn #f] #:tolerance [tolerance 1e-11]
                                  #:longest [longest 1e4])
  (/ (* 2 pi) (orbit-period (closed-orbit 'frequency-of-orbit H state turn tolerance longest))))

;; The motion goes away, and comes back where it began going the same way: the distance along the
;; first velocity passes 0, falling and then rising; where it does so elsewhere, it goes on.
(define (closed-orbit who H state turn tolerance longest)
  (define start (checked-start who H state))
  (define flow (Hamiltonian->state-derivative H))
  (define first-rate (flow start))
  (define (away s)
    (define inner (inner-state s))
    (g:+ (g:* (coordinate first-rate) (apart (coordinate inner) (coordinate start) turn))
         (g:* (momentum first-rate) (g:- (momentum inner) (momentum start)))))
  (define (until direction s)
    (define passing (event away #:direction direction #:terminal? #t))
    (define motion
      (evolve-trajectory (with-area flow) s longest #:events passing #:tolerance tolerance))
    (define end (trajectory-final-state motion))
    (when (null? (trajectory-events motion)) (raise-not-closed who state longest end))
    (check-time-free who H (inner-state end))
    end)
  (let follow ([s (up 0 (up (coordinate start) (momentum start)) 0)])
    (define end (until 'rising (until 'falling s)))
    (if (near? (inner-state end) start turn)
        (orbit (time end) (/ (abs (part end 2)) (* 2 pi)))
        (follow end))))

(define (raise-not-closed who state longest end)
  (raise-not-convergent who (format "the motion through ~a did not close by the time ~a"
                                    (value->text state) longest)
                        end +inf.0 #:show? #f))

;; (t, (q, p), area), of which the area grows as p dq
(define ((with-area flow) s)
  (define inner (inner-state s))
  (define rate (flow inner))
  (up 1
      (up (coordinate rate) (momentum rate))
      (g:* (momentum inner) (coordinate rate))))

(define (inner-state s) (up (time s) (part (part s 1) 0) (part (part s 1) 1)))
(define (part s i) (vector-ref (tuple-elements s) i))

;; q − q₀, and what is like it nearby and comes again at each turn
(define (apart q q0 turn)
  (if turn
      (g:* (/ turn (* 2 pi)) (g:sin (g:* (/ (* 2 pi) turn) (g:- q q0))))
      (g:- q q0)))

(define closeness 1e-5)
(define longest-orbit 1e4)       ; the time after which it is given up, where nobody says

(define (near? s start turn)
  (define dq (- (coordinate s) (coordinate start)))
  (define folded (if turn (- dq (* turn (round (/ dq turn)))) dq))
  (define size (+ 1 (abs (coordinate start)) (abs (momentum start))))
  (< (+ (abs folded) (abs (- (momentum s) (momentum start)))) (* closeness size)))

;; -> the state in flonums, with the time 0
(define (checked-start who H state)
  (check-Hamiltonian who H)
  (check-H-state who state)
  (define-values (q p) (values (coordinate state) (momentum state)))
  (unless (and (real? q) (real? p))
    (complain who "expected a state of one coordinate, in numbers; given ~a" (value->text state)))
  (when (at-rest? H state)
    (complain who "a state at rest has no period; given ~a" (value->text state)))
  (define start (up 0 (exact->inexact q) (exact->inexact p)))
  (check-time-free who H start)
  start)

(define (at-rest? H state)
  (define rate ((Hamiltonian->state-derivative H) state))
  (and (zero? (coordinate rate)) (zero? (momentum rate))))

;; Asked where the motion begins and where it comes to, at a few times
(define (check-time-free who H state)
  (define (energy t) (H (up t (coordinate state) (momentum state))))
  (unless (for/and ([t '(0.7318 2.913)]) (equal? (energy t) (energy 0.0)))
    (complain who "~a depends on the time, and its motions have no action" (value->text H))))

;; ---------------------------------------------------------------------------
;; Action and angle

;; ((state->action-angle H) state) : (t, θ, I), with θ between 0 and 2π since the coordinate was
;; `center`, rising
(define-plain (state->action-angle H #:center [center 0] #:turn [turn #f]
                                   #:tolerance [tolerance 1e-11])
  (define who 'state->action-angle)
  (check-Hamiltonian who H)
  (unary-function (lambda () (list who (value->datum H))) (state)
    (define o (closed-orbit who H state turn tolerance longest-orbit))
    (define wait (time-to-center who H state center turn tolerance (orbit-period o)))
    (define angle (* 2 pi (- 1 (/ wait (orbit-period o)))))
    (up (time state) (if (>= angle (* 2 pi)) (- angle (* 2 pi)) angle) (orbit-action o))))

;; The time until the coordinate is the center, rising
(define (time-to-center who H state center turn tolerance period)
  (define start (up 0 (exact->inexact (coordinate state)) (exact->inexact (momentum state))))
  (define flow (Hamiltonian->state-derivative H))
  (define (away s) (apart (coordinate s) center turn))
  (define (forwards? s) (> (coordinate (flow s)) 0))
  (cond
    [(and (= (away start) 0) (forwards? start)) 0]
    [else
     (define motion
       (evolve-trajectory flow start (* 1.01 period) #:tolerance tolerance
                          #:events (event away #:name 'passing #:direction 'rising)))
     ;; half a turn away the sine rises as the coordinate falls
     (or (for/first ([o (in-list (trajectory-events motion))]
                      #:when (forwards? (occurrence-state o)))
           (occurrence-time o))
         (raise-not-passing who state center turn start (trajectory-final-state motion)))]))

(define (raise-not-passing who state center turn start end)
  (when (and turn (< (- (coordinate end) (coordinate start)) (* -1/2 turn)))
    (complain who
              (string-append "the motion through ~a turns backwards, and has no positive action; "
                             "mirror the coordinate and the momentum")
              (value->text state)))
  (complain who
            "the motion through ~a does not pass the coordinate ~a forwards; #:center names one"
            (value->text state) center))

;; ((action-angle->state H) state) : the state with that angle and action
(define-plain (action-angle->state H #:center [center 0] #:turn [turn #f]
                                   #:tolerance [tolerance 1e-11])
  (define who 'action-angle->state)
  (check-Hamiltonian who H)
  (unary-function (lambda () (list who (value->datum H))) (state)
    (define-values (angle J) (values (coordinate state) (momentum state)))
    (unless (and (real? angle) (real? J) (> J 0))
      (complain who "expected an angle and a positive action, in numbers; given ~a"
                (value->text state)))
    (define (orbit-at p) (closed-orbit who H (up 0 center p) turn tolerance longest-orbit))
    (define p (momentum-at-center who H center orbit-at J))
    (define wait (* (orbit-period (orbit-at p)) (/ (- angle (* 2 pi (floor (/ angle (* 2 pi)))))
                                                   (* 2 pi))))
    (define start (up 0 (exact->inexact center) p))
    (define there
      (if (= wait 0)
          start
          (trajectory-final-state
           (evolve-trajectory (Hamiltonian->state-derivative H) start wait
                              #:tolerance tolerance))))
    (up (time state) (coordinate there) (momentum there))))

(define (momentum-at-center who H center orbit-at J)
  (define (action-at p)
    (if (at-rest? H (up 0 center p))
        0.0
        (with-handlers ([exn:fail:mechanics:not-convergent? (lambda (e) +inf.0)])
          (orbit-action (orbit-at p)))))
  (or (momentum-with-action action-at J)
      (complain who
                (string-append "no motion that closes and passes the coordinate ~a "
                               "was found with the action ~a; #:center names another")
                (value->text center) (value->text J))))
