#lang racket/base
;; A question about any state puts symbols of its own in place of the reader's, which all were
;; called x: so a Lagrangian that did not take the state complained of (up x x x).

(require mechanics
         "../support/messages.rkt")

(define (L (up t (up x y) (up vx vy))) (- (* 1/2 'm (+ (square vx) (square vy))) (* 'm 'g y)))
(define (energy state) ((Lagrangian->energy L) state))
(define flat (up 't 'x 'y 'vx 'vy))
(define all-flat
  (string-append
   "L: the argument does not match the pattern (up t (up x y) (up vx vy)): "
   "expected an up tuple of 3, given (up t x y vx vy) (an up tuple of 5)\n"
   "  grouped as in the pattern it is (up t (up x y) (up vx vy))"))

(says
 [(conserved-momenta L flat) all-flat]
 [(ignorable-coordinates L flat) all-flat]
 [(verify-ignorable L 'x flat) all-flat]
 [(verify-conserved L energy flat) all-flat]
 [(equilibria L flat) all-flat]
 [(verify-equivalent-Lagrangians L L flat) all-flat]
 [(conserved-momenta L (up 't 'x 'vx))
  "L: the argument does not match the pattern (up t (up x y) (up vx vy)): "
  "at component 1, expected an up tuple of 2, given x (a number-like expression)\n"
  "  in: (up t x vx)"])
