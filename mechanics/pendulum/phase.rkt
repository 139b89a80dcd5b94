#lang racket/base
;; Action and angle of the pendulum (scmutils' names).
;;
;; The angle is 0 where θ = 0 and p > 0, and grows at the frequency.  In the *global* variables
;; turns have half their angle and twice their action, those downwards are seen from the other
;; side, and the separatrix is the same curve from within and from without.

(require "pendulum.rkt"
         "../calculus/elliptic.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/elementary.rkt" "../generic/on-demand.rkt" "../generic/printed-function.rkt"
         "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt"
         "../lagrangian/local-tuple.rkt"
         "../numeric/constants.rkt"
         "../value/principal-value.rkt")

(require-on-demand ["../search/find-root.rkt" find-root])

(provide pendulum-oscillating-phase pendulum-circulating-phase
         pendulum-oscillating-dt pendulum-circulating-dt
         pendulum-oscillating-action-to-E pendulum-circulating-action-to-E
         pendulum-oscillating-state-to-aa-state pendulum-oscillating-aa-state-to-state
         pendulum-circulating-state-to-aa-state pendulum-circulating-aa-state-to-state
         pendulum-state-to-global-aa-state pendulum-global-aa-state-to-state
         ;; for motions
         define-of-state energy at-rest? in-turn mirrored downwards?)

;; (define-of-state (name argument ...) (state) body ...) : name, of the arguments, is a function
;; of the state that prints as its call
(define-syntax-rule (define-of-state (name argument ...) (state) body ...)
  (define (name argument ...)
    (printed-function (name argument ...) (state)
      (check-H-state 'name state)
      body ...)))

(define (energy alpha beta state) ((Hpendulum alpha beta) state))
(define in-turn (principal-value :pi))

;; ---------------------------------------------------------------------------
;; Phases

;; The time since θ = 0 with p > 0
(define-of-state (pendulum-oscillating-dt alpha beta) (state)
  (time-of-swing 'pendulum-oscillating-dt alpha beta state))

(define (time-of-swing who alpha beta state)
  (define E (energy alpha beta state))
  (check-swinging who alpha beta E)
  (when (at-rest? who beta E) (complain who "a pendulum at rest has no phase"))
  (define k (modulus beta E))
  (define s (g:/ (g:sin (g:* 1/2 (in-turn (coordinate state)))) k))
  (define dt (g:/ (elliptic-integral-F (asin-within s) k) (omega-0 alpha beta)))
  (if (downwards? who state)
      (g:- (g:/ pi (pendulum-oscillating-frequency alpha beta E)) dt)
      dt))

;; asin s; ±π/2 where rounding took the sine of the greatest angle beyond 1
(define (asin-within s)
  (define r (comparand s))
  (if (and (real? r) (>= (abs r) 1)) (if (> r 0) :pi/2 (- :pi/2)) (g:asin s)))

(define (at-rest? who beta E)
  (= (number-of who "the energy" E) (- (number-of who "beta" beta))))

(define-of-state (pendulum-circulating-dt alpha beta) (state)
  (time-of-turn 'pendulum-circulating-dt alpha beta state))

(define (time-of-turn who alpha beta state)
  (define E (energy alpha beta state))
  (check-turning who alpha beta E)
  (when (downwards? who state) (raise-downwards who state))
  (define u
    (elliptic-integral-F (g:* 1/2 (in-turn (coordinate state))) (turning-modulus beta E)))
  (g:/ u (omega-R alpha beta E)))

(define (raise-downwards who state)
  (complain who
            (string-append "the pendulum turns with a negative momentum, and this is for a "
                           "positive one; given ~a\n  the global variables are for both: "
                           "pendulum-state-to-global-aa-state")
            (value->text state)))

;; The angle, between −π and π
(define-of-state (pendulum-oscillating-phase alpha beta) (state)
  (phase 'pendulum-oscillating-phase alpha beta state time-of-swing))

(define-of-state (pendulum-circulating-phase alpha beta) (state)
  (phase 'pendulum-circulating-phase alpha beta state time-of-turn))

(define (phase who alpha beta state time-of)
  (define dt (time-of who alpha beta state))
  (in-turn (g:* (pendulum-frequency alpha beta (energy alpha beta state)) dt)))

;; ---------------------------------------------------------------------------
;; Energies of actions

(define-printed (pendulum-oscillating-action-to-E alpha beta)
  (lambda (action)
    (check-action 'pendulum-oscillating-action-to-E action 0
                  (pendulum-separatrix-action alpha beta))
    (define (E k) (g:* beta (g:- (g:* 2 (g:square k)) 1)))
    (energy-of-action pendulum-oscillating-action alpha beta action E 1e-9)))

(define-printed (pendulum-circulating-action-to-E alpha beta)
  (lambda (action)
    (check-action 'pendulum-circulating-action-to-E action
                  (g:* 1/2 (pendulum-separatrix-action alpha beta)) +inf.0)
    (define (E k) (g:* beta (g:- (g:/ 2 (g:square k)) 1)))
    (energy-of-action pendulum-circulating-action alpha beta action E 1e-6)))

;; The energy E(k) with the action, k being between `least` and 1, on which the action depends
;; monotonically
(define (energy-of-action action-at alpha beta action E least)
  (E (find-root (lambda (k) (g:- (action-at alpha beta (E k)) action)) least (- 1 1e-12))))

(define (check-action who action low high)
  (define J (number-of who "the action" action))
  (unless (< (number-of who "alpha" low) J (number-of who "alpha" high))
    (complain who "the action is to be between ~a and ~a; given ~a" low high action)))

;; ---------------------------------------------------------------------------
;; Action-angle states

(define-of-state (pendulum-oscillating-state-to-aa-state alpha beta) (state)
  (aa-state 'pendulum-oscillating-state-to-aa-state alpha beta state
            time-of-swing pendulum-oscillating-action))

(define-of-state (pendulum-circulating-state-to-aa-state alpha beta) (state)
  (aa-state 'pendulum-circulating-state-to-aa-state alpha beta state
            time-of-turn pendulum-circulating-action))

(define (aa-state who alpha beta state time-of action)
  (up (time state)
      (phase who alpha beta state time-of)
      (action alpha beta (energy alpha beta state))))

(define-of-state (pendulum-oscillating-aa-state-to-state alpha beta) (state)
  (state-of-aa alpha beta state pendulum-oscillating-action-to-E pendulum-oscillating-frequency
               pendulum-oscillating-angle pendulum-oscillating-angular-momentum))

(define-of-state (pendulum-circulating-aa-state-to-state alpha beta) (state)
  (state-of-aa alpha beta state pendulum-circulating-action-to-E pendulum-circulating-frequency
               pendulum-circulating-angle pendulum-circulating-angular-momentum))

(define (state-of-aa alpha beta state action-to-E frequency angle angular-momentum)
  (define E ((action-to-E alpha beta) (momentum state)))
  (define t (g:/ (coordinate state) (frequency alpha beta E)))
  (up (time state)
      ((angle alpha beta E) t)
      ((angular-momentum alpha beta E) t)))

;; ---------------------------------------------------------------------------
;; For all energies

(define (mirrored state)
  (up (time state) (g:negate (coordinate state)) (g:negate (momentum state))))

(define (downwards? who state) (negative? (number-of who "the momentum" (momentum state))))

(define-of-state (pendulum-state-to-global-aa-state alpha beta) (state)
  (define who 'pendulum-state-to-global-aa-state)
  (cond
    [(swinging? who alpha beta (energy alpha beta state))
     ((pendulum-oscillating-state-to-aa-state alpha beta) state)]
    [else
     (define down? (downwards? who state))
     (define aa ((pendulum-circulating-state-to-aa-state alpha beta)
                 (if down? (mirrored state) state)))
     (define half (g:* 1/2 (coordinate aa)))
     (up (time aa)
         (if down? (in-turn (g:+ pi half)) half)
         (g:* 2 (momentum aa)))]))

(define-of-state (pendulum-global-aa-state-to-state alpha beta) (state)
  (define who 'pendulum-global-aa-state-to-state)
  (define-values (angle J) (values (in-turn (coordinate state)) (momentum state)))
  (define separatrix (pendulum-separatrix-action alpha beta))
  (cond
    [(< (number-of who "the action" J) (number-of who "alpha" separatrix))
     ((pendulum-oscillating-aa-state-to-state alpha beta) state)]
    [else
     (define down? (> (abs (number-of who "the angle" angle)) :pi/2))
     (define turned ((pendulum-circulating-aa-state-to-state alpha beta)
                     (up (time state)
                         (g:* 2 (if down? (g:- angle pi) angle))
                         (g:* 1/2 J))))
     (if down? (mirrored turned) turned)]))
