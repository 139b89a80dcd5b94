#lang racket/base
;; Transformations of phase space: functions C that take a new state (t, q', p') to the old one
;; (t, q, p); and the errors of functions that are none.

(require "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/compare.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/on-demand.rkt" "../generic/scalar.rkt" "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt"
         "../value/shape.rkt" "../value/structure.rkt")

(require-on-demand ["../lagrangian/generic-state.rkt" check-symbols check-parameters])

(provide check-transformation check-for-any-state
         transformed checked-transformation image-and-slopes)

(define (check-transformation who C)
  (unless (and (of-functions? C) (accepts? C 1))
    (complain who
              "expected a transformation, a function of the state (up t q p); given ~a~a"
              (describe-function C)
              (cond [(H-state? C) "\n  the transformation comes first, the state after it"]
                    [(of-functions? C)
                     (format "\n  if it takes parameters first, supply them: (~a (~a ...) ...)"
                             who (value->text C))]
                    [else ""]))))

;; C is asked about at any state: the symbols of `state` must be no parameters of it.
(define (check-for-any-state who C state)
  (check-transformation who C)
  (check-H-state who state)
  (check-symbols who state "state")
  (void (transformed who C state))
  (check-parameters who C state "state"))

;; C at a state; the value must be a state of as many coordinates.
(define (transformed who C state)
  (check-H-state who state)
  (define old (C state))
  (unless (H-state? old) (raise-no-state who C (underlying old) state))
  (unless (= (degrees-of-freedom old) (degrees-of-freedom state))
    (complain who "~a takes ~a ~a to ~a; a canonical transformation keeps their number"
              (value->text C) (degrees-of-freedom state)
              (if (= (degrees-of-freedom state) 1) "coordinate" "coordinates")
              (degrees-of-freedom old)))
  old)

;; A scalar without the derivatives that it carries
(define (underlying x) (if (scalar? x) (comparand x) x))

;; C, whose values are checked to be such states.
(define (checked-transformation who C)
  (check-transformation who C)
  (unary-function (lambda () (value->datum C)) (state) (transformed who C state)))

(define (raise-no-state who C old state)
  (complain who "a transformation takes a state (up t q p) to another one; ~a gives ~a~a"
            (value->text C) (describe-with-value old) (remedy old state)))

(define (remedy old state)
  (define (parts n) (and (tuple? old) (= (s:length old) n)))
  (define (like-state? i j) (same-shape? (ref old i) (ref state j)))
  (cond [(scalar? old)
         "\n  that is no state, but what a Hamiltonian gives; the transformation comes first"]
        [(pointwise? old) "\n  was a parameter left out?"]
        [(and (parts 2) (like-state? 0 1) (like-state? 1 2))
         "\n  the time is missing: (up t q p)"]
        [(and (parts 3) (up? old) (like-state? 1 1))
         "\n  the third part is to be the momenta, dual to the coordinates"]
        [else
         "\n  a transformation of the coordinates alone is extended by (F->CH F)"]))

;; ---------------------------------------------------------------------------
;; Derivatives

;; F at a state, and the list of its derivatives by the scalars of the state
(define (image-and-slopes F state)
  (for/fold ([image #f] [slopes '()] #:result (values image (reverse slopes)))
            ([k (in-range (shape-length state))])
    (define-values (value slope)
      (value-and-derivative-along F state (unit-structure state k)))
    (values (or image value) (cons slope slopes))))
