#lang racket/base
;; Actions and frequencies of motions that separate, in numbers (SICM 6.1).
;;
;; Each pᵢ(qⁱ) = m ± √R with R of the coordinate and the constants: between two zeros of R the
;; coordinate swings, and
;;
;;     Jᵢ = 1/2π ∮ pᵢ dqⁱ = 1/π ∫ √R dq,     ∂Jᵢ/∂α = 1/π ∫ (∂R/∂α)/(2 √R) dq.
;;
;; With q as far from an end as the width times sin² v/2 both integrands are smooth and even about
;; the ends in v, however steep √R is there (half-turn-average.rkt).
;;
;; A coordinate that does not occur in H is an angle of 2π: its action is its momentum.
;; The frequencies are ∂E/∂Jᵢ, the row of the energy in the inverse of ∂J/∂α.

(require (only-in racket/math sqr)
         "half-turn-average.rkt" "momentum-by-energy.rkt" "separation.rkt" "turning-point.rkt"
         "separated-equation.rkt"
         "../algebra/expression/symbols.rkt"
         "../calculus/expression-function.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/describe.rkt"
         "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/shape.rkt" "../value/simplify.rkt"
         "../value/matrix/linear-algebra.rkt" "../value/matrix/matrix.rkt")

(provide separation-actions separation-frequencies)

;; ---------------------------------------------------------------------------
;; For users

;; Of the motion through a state of numbers, of the shape of the coordinates
(define (separation-actions s state)
  (like-coordinates s (map action (swings 'separation-actions s state))))

(define (separation-frequencies s state)
  (define all (swings 'separation-frequencies s state))
  (define constants (separation-constants s))
  (define slopes
    (for/list ([w (in-list all)])
      (check-swinging w)
      (for/list ([c (in-list constants)]) (action-slope w c))))
  (define by-energy
    (solve-linear-left (transpose (apply matrix-by-rows slopes))
                       (apply up 1.0 (map (lambda (_) 0.0) (cdr constants)))))
  (like-coordinates s (scalars by-energy)))

(define (like-coordinates s xs) (list->structure (coordinate (separation-state s)) xs))

;; -> ((constant . number) …)
(define (constants-at who s state)
  (check-separation who s)
  (check-state-like who (separation-state s) state)
  (unless (andmap real? (scalars state))
    (complain who "expected a state in numbers; given ~a" (value->text state)))
  (check-swings who s)
  (for/list ([c (in-list (separation-constants s))] [f (in-list (separation-integrals s))])
    (define v (without-rounding f state))
    (unless (real? v)
      (complain who "the parameters of ~a are to be numbers; there is ~a"
                (value->text (separation-H s)) (car (symbols-in v))))
    (cons c (exact->inexact v))))

;; f without rounding: near an end the terms of the energy are far greater than their sum.
(define (without-rounding f state)
  (define (exactly x) (if (rational? x) (inexact->exact x) x))
  (if-raised divided-by-zero? (f state) (f (s:map/r exactly state))))

;; The energy must be a symbol: with a number all actions would be those of that energy, whatever
;; the state.  A coordinate whose equation is linear in its momentum never turns back.
(define (check-swings who s)
  (unless (symbol? (separation-energy s))
    (complain who (string-append "the separation is that of one energy, ~a; actions belong to one "
                                 "with a symbol for it, as E")
              (value->text (separation-energy s))))
  (for ([x (in-list (separation-pieces s))] #:unless (piece-cyclic? x))
    (when (eqv? 1 (degree-of x))
      (raise-no-answer who (string-append "the coordinate ~a does not turn back: its momentum is "
                                          "a function of it\n  ~a = ~a")
                       (piece-q x) (piece-p x) (value->text (momentum-of x))))))

;; ---------------------------------------------------------------------------
;; One coordinate

;; piece : of the separation; radicand : R in p = m ± √R, an expression; low, high : the zeros of
;; it that `start` is between; point : the constants.  Of a cyclic coordinate all but the piece
;; and the point are #f.
(struct swing (who piece radicand start low high point) #:authentic)

(define (swings who s state)
  (define point (constants-at who s state))
  (for/list ([x (in-list (pieces-by-coordinate s))]
             [start (in-list (scalars (coordinate state)))])
    (if (piece-cyclic? x)
        (swing who x #f #f #f #f point)
        (swing-about who x (exact->inexact start) point))))

(define (swing-about who x start point)
  (define-values (_middle R) (middle-and-radicand (lambda (p) (equation-at x p)) 0))
  (define e (simplify R))
  (define r (radicand-of e x point))
  (define (turn direction)
    (or (turning-point r start direction)
        (raise-no-answer
         who "the coordinate ~a does not turn back: its motion from ~a has no action"
         (piece-q x) start)))
  (swing who x e start (turn -1.0) (turn 1.0) point))

(define (radicand-of e x point)
  (define D (denominator-of e))
  (define (number-at e) (number-function e x point))
  (define (slope e) (number-at (expression-derivative e (piece-q x))))
  (radicand (number-at e) (slope e) (number-at D) (slope D)))

(define ((number-function e x point) q)
  (define v (evaluate-generically e (cons (cons (piece-q x) q) point)))
  (if (real? v) (exact->inexact v) +nan.0))

;; At rest a coordinate has an action, 0, but no slopes of it.
(define (check-swinging w)
  (define start (swing-start w))
  (when (and start (resting? w))
    (complain (swing-who w)
              "the coordinate ~a rests at ~a: its frequency is that of a small swing about it"
              (piece-q (swing-piece w)) start)))

;; Rounding leaves a swing of that part where the zeros of R are one; about 0, next to nothing.
(define (resting? w)
  (define-values (low high) (values (swing-low w) (swing-high w)))
  (<= (- high low) (max 1e-100 (* 1e-7 (max (abs low) (abs high))))))

;; ---------------------------------------------------------------------------
;; Integrals over it

(define (action w)
  (define x (swing-piece w))
  (cond [(piece-cyclic? x) (cdr (assq (piece-constant x) (swing-point w)))]
        [(resting? w) 0.0]
        [else (between-turns w (lambda (R q) (sqrt (max 0.0 R))))]))

;; ∂J/∂c
(define (action-slope w c)
  (define x (swing-piece w))
  (cond [(piece-cyclic? x) (if (eq? c (piece-constant x)) 1.0 0.0)]
        [else
         (define slope (expression-derivative (swing-radicand w) c))
         (define dR (number-function slope x (swing-point w)))
         (between-turns w (lambda (R q) (if (> R 0.0) (/ (dR q) (* 2.0 (sqrt R))) 0.0)))]))

;; 1/π of the integral of (f R q) over the swing
(define (between-turns w f)
  (define R (number-function (swing-radicand w) (swing-piece w) (swing-point w)))
  (define-values (low high) (values (swing-low w) (swing-high w)))
  (define width (- high low))
  (define ((from end step) v)
    (define q (step end (* width (sqr (sin (* 0.5 v))))))
    (* (f (R q) q) (* 0.5 width (sin v))))
  (average-over-half-turn
   (from low +)
   (from high -)
   (lambda (value change)
     (raise-not-convergent
      (swing-who w)
      (format "the integral over the swing of ~a did not converge" (piece-q (swing-piece w)))
      value change))))
