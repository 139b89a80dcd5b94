#lang racket/base
;; From momenta to velocities: the v at which the gradient ∂F/∂v is w.
;;
;; F depends on v and on given values, the time and coordinates.  Of a quadratic F the
;; equations are solved exactly: M v = w − b, with the second derivatives M and the gradient b at
;; v = 0; its Legendre transform w v − F(v) is (w − b) v / 2 − F(0).  Other equations may have a
;; formula (velocity-formula.rkt).
;;
;; Second derivatives without an inverse leave velocities open: directions without inertia.

(require "equation-solver.rkt"
         "../calculus/derivative.rkt"
         "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/on-demand.rkt"
         (only-in "../lagrangian/state-derivative.rkt" directions->text)
         "../numeric/finite-number.rkt"
         "../value/shape.rkt" "../value/simplify.rkt" "../value/structure.rkt")

;; Most Lagrangians are quadratic.
(require-on-demand
 ["velocity-formula.rkt" solve-gradient]
 ["../search/implicit-root.rkt" plain])

(provide make-inverter velocity-at transform-at)

;; who : complains; F : given v -> number; solver : of ∂F/∂v = w
(struct inverter (who F solver) #:authentic)

(define (make-inverter who F)
  (define (find-formula gradient slopes v w)
    (solve-gradient gradient slopes (scalars v) (scalars w)))
  (define (by-numbers s given like w)
    (define start (starting-velocity s (plain given) (plain like) (plain w)))
    (solution-by-numbers s (sought who) given w start))
  (inverter who F
            (make-solver who
                         (lambda (given v) (derivative-at (lambda (v) (F given v)) v))
                         find-formula by-numbers
                         (lambda (M e) (raise-no-inertia who M e)))))

;; given : a tuple; w : momenta, or whatever is dual to v
(define (velocity-at i given w)
  (define who (inverter-who i))
  (define-values (s zero) (values (inverter-solver i) (compatible-zero w)))
  (define v (solution-at s given zero w))
  ;; No velocity has a momentum of which a formula is the logarithm of a negative number, say.
  (unless (solved-exactly? s given zero w)
    (when (ormap not-real? (scalars (plain v)))
      (raise-none-found who (sought who) w (plain v) #f)))
  v)

;; w v − F(v) at that v
(define (transform-at i given w)
  (define (F v) ((inverter-F i) given v))
  (define-values (s zero) (values (inverter-solver i) (compatible-zero w)))
  (cond [(solved-exactly? s given zero w)
         (define-values (M push) (linear-equations s given zero w))
         (g:- (g:* 1/2 push (solved s M push)) (F zero))]
        [else
         (define v (velocity-at i given w))
         (g:- (g:* w v) (F v))]))

;; The solution for a quadratic F; if it has no value, the momenta themselves.
(define (starting-velocity s given zero w)
  (with-handlers ([no-value? (lambda (e) (flip w))])
    (linear-solution s given zero w)))

;; ---------------------------------------------------------------------------
;; Failures

(define (raise-no-inertia who M e)
  (define back (back? who))
  (raise-without-inverse
   who
   (string-append
    "the second derivatives have no inverse; "
    (if back "momenta do not follow from velocities" "velocities do not follow from momenta")
    (directions->text e (if back "the same velocity" "no inertia") simplify)
    (format "\n  second derivatives: ~a" (value->text (simplify M))))
   M
   (or (exn:fail:mechanics:singular:matrix-null-vectors e) '())
   e))

;; Are momenta sought, those of velocities?
(define (back? who) (eq? who 'Hamiltonian->Lagrangian))

(define (sought who) (if (back? who) "momenta" "velocities"))
