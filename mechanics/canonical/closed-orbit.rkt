#lang racket/base
;; A motion of one coordinate that closes: its period and the area that it encloses.
;;
;; It is followed by integration until it comes back to where it began, going the same way.  A
;; coordinate that is an angle may close by a turn.

(require "orbit-scale.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt"
         (only-in "../generic/number-argument.rkt" known-number) "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamilton-equations.rkt"
         "../hamiltonian/Hamiltonian.rkt"
         "../lagrangian/local-tuple.rkt"
         (only-in "../motion/on-demand.rkt" event evolve-trajectory
                  trajectory-events trajectory-final-state)
         "../motion/system/check.rkt"
         "../numeric/constants.rkt"
         "../value/shape.rkt" "../value/simplify.rkt")

(provide (struct-out orbit) closed-orbit at-rest? longest-orbit check-options check-time-free)

(struct orbit (period action) #:authentic)

;; The motion goes away, and comes back where it began going the same way: the distance along the
;; first velocity passes 0, falling and then rising; where it does so elsewhere, it goes on.  An
;; angle may go a whole turn instead: its distance from the start tells, however long the steps.
;; A small orbit is followed in its own scale (orbit-scale.rkt).
(define (closed-orbit who H state turn tolerance longest)
  (define given (checked-start who H state))
  (when turn (check-turn who H given turn))
  (define c (scale-of-orbit H given))
  (define start (in-scale c given))
  (define turn-here (and turn (/ turn (scale-coordinate c))))
  (define (unscaled s) (out-of-scale c (inner-state s)))
  (define flow (Hamiltonian->state-derivative (Hamiltonian-in-scale H c)))
  (define (moved s) (g:- (coordinate (inner-state s)) (coordinate start)))
  (define (area s) (* (scale-action c) (structure-ref s 2)))
  (define away (distance-along (flow start) start))
  (define (beyond-turn s) (g:- (g:* (moved s) (moved s)) (* turn-here turn-here)))
  (define (turned? s) (and turn (> (abs (moved s)) (* almost turn-here))))
  (define whole-turn (if turn (list (event beyond-turn #:terminal? #t)) '()))
  (define (until direction s)
    (define events (cons (event away #:direction direction #:terminal? #t) whole-turn))
    (define motion
      (with-handlers ([exn:fail:mechanics:singular? (lambda (e) (raise-runs-away who state e))])
        (evolve-trajectory (with-area flow) s longest #:events events #:tolerance tolerance)))
    (define end (trajectory-final-state motion))
    (when (null? (trajectory-events motion))
      (raise-not-closed who H state (unscaled end) turn longest (area end)))
    (begin0 end (check-time-free who H (unscaled end))))
  (let follow ([s (up 0 (up (coordinate start) (momentum start)) 0)])
    (define fallen (until 'falling s))
    (define end (if (turned? fallen) fallen (until 'rising fallen)))
    (cond [(near? (inner-state end) start turn-here)
           (orbit (time end) (/ (area end) (* 2 pi)))]
          [(turned? end) (raise-no-turn who H turn)]
          [else (follow end)])))

(define ((distance-along rate start) s)
  (define here (inner-state s))
  (g:+ (g:* (coordinate rate) (g:- (coordinate here) (coordinate start)))
       (g:* (momentum rate) (g:- (momentum here) (momentum start)))))

(define almost (- 1 1e-9))

(define (raise-runs-away who state e)
  (raise-not-convergent who (format "the motion through ~a does not close: ~a" (value->text state)
                                    (after-name (exn-message e)))
                        (exn:fail:mechanics:singular-where e) +inf.0 #:show? #f))

;; "evolve-trajectory: the motion …" without the name, and without states that hold the area
(define (after-name message)
  (regexp-replace* #rx"\n  (last state|state derivative)[^\n]*"
                   (regexp-replace #rx"^[^ ]*: " message "") ""))

;; there : the state reached; turn : the given one, or #f; area : that under the motion
(define (raise-not-closed who H state there turn longest area)
  (raise-not-convergent who (format "the motion through ~a did not close by the time ~a~a"
                                    (value->text state) longest
                                    (if (and (not turn) (turns? H state there)) turn-hint ""))
                        (up (time there) (up (coordinate there) (momentum there)) area) +inf.0
                        #:show? #f))

;; Did it go round an angle?  Not known for a coordinate on which H does not depend.
(define (turns? H state there)
  (and (> (abs (- (coordinate there) (coordinate state))) (* 2 pi))
       (comes-again? H there (* 2 pi))
       (not (comes-again? H there 1.0))))

(define turn-hint
  "\n  it goes round; #:turn (* 2 pi) says that its coordinate comes again after a turn")

;; (t, (q, p), area), of which the area grows as p dq
(define ((with-area flow) s)
  (define inner (inner-state s))
  (define rate (flow inner))
  (up 1
      (up (coordinate rate) (momentum rate))
      (g:* (momentum inner) (coordinate rate))))

(define (inner-state s)
  (define inner (structure-ref s 1))
  (up (time s) (structure-ref inner 0) (structure-ref inner 1)))

(define closeness 1e-5)
(define longest-orbit 1e4)       ; the time after which it is given up, where nobody says

(define (near? s start turn)
  (define dq (- (coordinate s) (coordinate start)))
  (define folded (if turn (- dq (* turn (round (/ dq turn)))) dq))
  (define size (+ 1 (abs (coordinate start)) (abs (momentum start))))
  (< (+ (abs folded) (abs (- (momentum s) (momentum start)))) (* closeness size)))

;; The options that all questions about orbits have
(define (check-options who turn tolerance [longest longest-orbit] [center 0])
  (when turn (check-positive who "turn of the coordinate" turn))
  (check-tolerance who tolerance)
  (check-positive who "time after which to give up" longest)
  (check-real who "center" center))

;; -> the state in flonums, with the time 0
(define (checked-start who H state)
  (check-Hamiltonian-and-state who H state)
  (define-values (q p) (values (coordinate state) (momentum state)))
  (unless (and (rational? q) (rational? p))
    (complain who "expected a state of one coordinate, in ~anumbers; given ~a"
              (if (and (real? q) (real? p)) "finite " "") (value->text state)))
  (check-numbers who H state)
  (define start (up 0 (exact->inexact q) (exact->inexact p)))
  (check-time-free who H start)
  (when (at-rest? H state)
    (complain who "a state at rest has no period; given ~a" (value->text state)))
  start)

;; Degrees are easily given, and close no motion that radians do not.
(define (check-turn who H start turn)
  (unless (comes-again? H start turn)
    (raise-no-turn who H turn
                   (if (comes-again? H start (* 2 pi)) "\n  after (* 2 pi) it does" ""))))

(define (raise-no-turn who H turn [hint ""])
  (complain who
            (string-append "the coordinate of ~a does not come again after a turn of ~a: its "
                           "value is another there~a")
            (value->text H) (value->text turn) hint))

;; Has H the same values a turn on, at the state and at a few places beside it?
(define (comes-again? H state turn)
  (define (energy q)
    (with-handlers ([refusal? (lambda (e) #f)]) (H (up 0.0 q (momentum state)))))
  (for/and ([beside '(0.0 0.7318 -1.913)])
    (define q (+ (coordinate state) beside))
    (define-values (here there) (values (energy q) (energy (+ q turn))))
    (or (not (rational? here))
        (not (rational? there))
        (<= (abs (- there here)) (* 1e-8 (+ 1 (abs here) (abs there)))))))

(define (check-numbers who H state)
  (for ([x (in-list (scalars ((Hamiltonian->state-derivative H) state)))] #:unless (known-number x))
    (complain who "the parameters of ~a are to be numbers; there is ~a~a" (value->text H)
              (value->text (simplify x)) "\n  (H state) is to be a number")))

(define (at-rest? H state)
  (define rate ((Hamiltonian->state-derivative H) state))
  (and (zero? (coordinate rate)) (zero? (momentum rate))))

;; H at the state must be the same at a few times.
(define (check-time-free who H state)
  (define (energy t) (H (up t (coordinate state) (momentum state))))
  (unless (for/and ([t '(0.7318 2.913)]) (equal? (energy t) (energy 0.0)))
    (complain who "~a depends on the time, and its motions have no action" (value->text H))))
