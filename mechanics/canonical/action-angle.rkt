#lang racket/base
;; Action and angle of systems with one coordinate, by integration (SICM 5.8 and 6.1).
;;
;; The motion through a state is followed until it closes: it encloses 2π I = ∮ p dq, takes the
;; period T, and turns at ω = 2π/T = dE/dI.  The angle is ω times the time since the motion passed
;; a given coordinate, forwards.  A coordinate that is an angle may close by a turn.

(require "closed-orbit.rkt" "orbit-scale.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/note.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/on-demand.rkt" "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamilton-equations.rkt"
         "../hamiltonian/Hamiltonian.rkt"
         "../lagrangian/local-tuple.rkt"
         (only-in "../motion/on-demand.rkt" event evolve-trajectory occurrence-time
                  trajectory-events trajectory-final-state)
         "../numeric/constants.rkt")

(require-on-demand ["../search/find-root.rkt" find-root])

(provide action-of-orbit frequency-of-orbit state->action-angle action-angle->state)

;; ---------------------------------------------------------------------------
;; Orbits

;; turn : of a coordinate that is an angle, or #f; longest : the time after which to give up
(define-plain (action-of-orbit H state #:turn [turn #f] #:tolerance [tolerance 1e-11]
                               #:longest-time [longest 1e4])
  (orbit-action (checked-orbit 'action-of-orbit H state turn tolerance longest)))

(define-plain (frequency-of-orbit H state #:turn [turn #f] #:tolerance [tolerance 1e-11]
                                  #:longest-time [longest 1e4])
  (define (period tolerance)
    (orbit-period (checked-orbit 'frequency-of-orbit H state turn tolerance longest)))
  (/ (* 2 pi) (settled-period 'frequency-of-orbit period tolerance)))

;; Next to a separatrix an error of the energy becomes a much greater one of the period.  So the
;; tolerance is made smaller until the period does not change.  The last change may be less
;; than the error by some factor.
;; period : tolerance -> the period
(define (settled-period who period tolerance)
  (define enough (max 1e-9 (* 100 tolerance)))
  (let tighten ([tolerance tolerance] [rough (period tolerance)])
    (define closer (max (* 0.01 tolerance) least-tolerance))
    (define T (period closer))
    (define off (abs (- 1 (/ rough T))))
    (cond [(<= off enough) T]
          [(> closer least-tolerance) (tighten closer T)]
          [else
           (when (> off half-of-the-digits)
             (note-with-result (format near-separatrix who (about off))))
           T])))

(define least-tolerance 1e-14)
(define half-of-the-digits 5e-9)
(define near-separatrix
  (string-append "~a: roundings leave fewer than half of the digits, for the motion nearly comes\n"
                 "  to rest on its way, as next to a separatrix; ~a of the frequency is uncertain"))

(define (about x) (format "about 1e~a" (inexact->exact (round (/ (log x) (log 10))))))

(define (checked-orbit who H state turn tolerance longest)
  (check-options who turn tolerance longest)
  (closed-orbit who H state turn tolerance longest))

;; ---------------------------------------------------------------------------
;; Action and angle

;; ((state->action-angle H) state) : (t, θ, I), with θ between 0 and 2π since the coordinate was
;; `center`, rising
(define-plain (state->action-angle H #:center [center 0] #:turn [turn #f]
                                   #:tolerance [tolerance 1e-11])
  (define who 'state->action-angle)
  (check-Hamiltonian who H)
  (check-options who turn tolerance longest-orbit center)
  (printed-function (state->action-angle H) (state)
    (define o (closed-orbit who H state turn tolerance longest-orbit))
    (define wait (time-to-center who H state center turn tolerance (orbit-period o)))
    (define angle (* 2 pi (- 1 (/ wait (orbit-period o)))))
    (up (time state) (if (>= angle (* 2 pi)) (- angle (* 2 pi)) angle) (orbit-action o))))

;; The time until the coordinate is the center, rising
(define (time-to-center who H state center turn tolerance period)
  (define start (up 0 (exact->inexact (coordinate state)) (exact->inexact (momentum state))))
  (define flow (Hamiltonian->state-derivative H))
  (define (forwards? s) (> (coordinate (flow s)) 0))
  (define centers (centers-around (coordinate start) center turn))
  (cond
    [(and (memv (coordinate start) centers) (forwards? start)) 0]
    [else
     (define scale (scale-of-orbit H start))
     (define (passing c)
       (define here (/ c (scale-coordinate scale)))
       (event (lambda (s) (g:- (coordinate s) here)) #:name 'passing #:direction 'rising))
     (define motion
       (motion-in-scale H scale start (* 1.01 period) tolerance (map passing centers)))
     (define met (trajectory-events motion))
     (if (pair? met)
         (occurrence-time (car met))
         (raise-not-passing who state center turn start
                            (out-of-scale scale (trajectory-final-state motion))))]))

;; The motion from `start`, in the scale of the orbit
(define (motion-in-scale H scale start duration tolerance [events '()])
  (evolve-trajectory (Hamiltonian->state-derivative (Hamiltonian-in-scale H scale))
                     (in-scale scale start) duration #:tolerance tolerance #:events events))

;; The center; of an angle the centers next to q on both sides
(define (centers-around q center turn)
  (cond [turn
         (define above (+ center (* turn (ceiling (/ (- q center) turn)))))
         (map exact->inexact (list (- above turn) above))]
        [else (list (exact->inexact center))]))

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
  (check-options who turn tolerance longest-orbit center)
  (printed-function (action-angle->state H) (state)
    (define-values (angle J) (values (coordinate state) (momentum state)))
    (unless (and (real? angle) (real? J) (> J 0))
      (complain who "expected an angle and a positive action, in numbers; given ~a"
                (value->text state)))
    (define (orbit-at p) (closed-orbit who H (up 0 center p) turn tolerance longest-orbit))
    (define p (momentum-at-center who H center orbit-at J))
    (define wait (* (orbit-period (orbit-at p)) (/ (- angle (* 2 pi (floor (/ angle (* 2 pi)))))
                                                   (* 2 pi))))
    (define start (up 0 (exact->inexact center) p))
    (define scale (scale-of-orbit H start))
    (define there
      (out-of-scale
       scale (trajectory-final-state (motion-in-scale H scale start wait tolerance))))
    (up (time state) (coordinate there) (momentum there))))

(define (momentum-at-center who H center orbit-at J)
  (define (action-at p)
    (check-time-free who H (up 0 center p))
    (if (at-rest? H (up 0 center p))
        0.0
        (with-handlers ([exn:fail:mechanics:not-convergent? (lambda (e) +inf.0)])
          (orbit-action (orbit-at p)))))
  (or (momentum-with-action action-at J)
      (complain who
                (string-append "no motion that closes and passes the coordinate ~a "
                               "was found with the action ~a; #:center names another")
                (value->text center) (value->text J))))

;; ---------------------------------------------------------------------------
;; The momentum at a coordinate, of the motion that has a given action
;;
;; The action grows with the momentum, but not from 0 where the coordinate is no place of rest,
;; nor without a jump at a separatrix; beyond a separatrix a motion may not close at all, which
;; counts as an action that is too large.  So the root is checked before it is returned.

(define most-rounds 60)
(define closeness 1e-6)      ; of the action found, relative to that asked for

;; action-at : p -> the action, +inf.0 where the motion does not close;  -> p, or #f if none has J
(define (momentum-with-action action-at J)
  (and (< (action-at 0.0) J)
       (let-values ([(low high) (bracket action-at J)])
         (and high
              (let ([p (find-root (lambda (p) (- (action-at p) J)) low high #:tolerance 1e-13)])
                (and (<= (abs (- (action-at p) J)) (* closeness J)) p))))))

;; -> momenta with an action below J, and one above it that is finite; or #f and #f
(define (bracket action-at J)
  (let widen ([low 0.0] [high (sqrt (* 2.0 J))] [beyond #f] [rounds most-rounds])
    (define action (action-at high))
    (cond [(or (= rounds 0) (and beyond (< (- beyond low) (* closeness beyond)))) (values #f #f)]
          [(= action +inf.0) (widen low (/ (+ low high) 2) high (sub1 rounds))]
          [(> action J) (values low high)]
          [else
           (widen high (if beyond (/ (+ high beyond) 2) (* 2 high)) beyond (sub1 rounds))])))
