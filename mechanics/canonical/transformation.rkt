#lang racket/base
;; Transformations of phase space: functions C that take a new state (t, q', p') to the old one
;; (t, q, p); and what is wrong with those that are none.

(require "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt"
         "../value/structure.rkt")

(provide check-transformation transformed checked-transformation)

(define (check-transformation who C)
  (unless (and (of-functions? C) (accepts? C 1))
    (complain who
              "expected a transformation, a function of the state (up t q p); given ~a~a"
              (describe-function C)
              (if (of-functions? C)
                  (format "\n  if it takes parameters first, supply them: (~a (~a ...) ...)"
                          who (value->text C))
                  ""))))

;; C at a state, refusing what is not a state of as many coordinates.
(define (transformed who C state)
  (check-H-state who state)
  (define old (C state))
  (unless (H-state? old) (raise-no-state who C old state))
  (unless (= (degrees-of-freedom old) (degrees-of-freedom state))
    (complain who "~a takes ~a coordinates to ~a; a canonical transformation keeps their number"
              (value->text C) (degrees-of-freedom state) (degrees-of-freedom old)))
  old)

;; C with that check.
(define (checked-transformation who C)
  (check-transformation who C)
  (unary-function (lambda () (value->datum C)) (state) (transformed who C state)))

(define (raise-no-state who C old state)
  (complain who "a transformation takes a state (up t q p) to another one; ~a gives ~a~a"
            (value->text C) (describe-with-value old) (remedy old state)))

(define (remedy old state)
  (define (part i) (vector-ref (tuple-elements old) i))
  (define (parts n) (and (tuple? old) (= (structure-length (adopt old)) n)))
  (define (like-state? x i) (same-shape? x (vector-ref (tuple-elements state) i)))
  (cond [(pointwise? old) "\n  was a parameter left out?"]
        [(and (parts 2) (like-state? (part 0) 1) (like-state? (part 1) 2))
         "\n  the time is missing: (up t q p)"]
        [(and (parts 3) (up? old) (like-state? (part 1) 1))
         "\n  the third part is to be the momenta, dual to the coordinates"]
        [else
         "\n  a transformation of the coordinates alone is extended by (F->CH F)"]))
