#lang racket/base
;; An energy with a coordinate in it was separated, and what came out proved; actions of a
;; separation at one energy were of that energy, whatever the state; and a momentum that is linear
;; ended in a division by zero.

(require mechanics
         "../support/messages.rkt")

(define (oscillator s) (* 1/2 (+ (square (ref s 2)) (square (ref s 1)))))
(define (clocked s)
  (+ (ref s 2 0) (square (ref s 1 0)) (oscillator (up 0 (ref s 1 1) (ref s 2 1)))))

(says
 [(separate-Hamilton-Jacobi oscillator (up 't 'x 'p) #:energy (* 2 'x))
  "separate-Hamilton-Jacobi: the energy is constant, and does not depend on the state; "
  "given (* 2 x)"]
 [(separation-actions (separate-Hamilton-Jacobi oscillator (up 't 'x 'p) #:energy 2) (up 0 1 0))
  "separation-actions: the separation is that of one energy, 2; actions belong to one with a "
  "symbol for it, as E"])

(check-message
 (string-append "separation-actions: the coordinate s does not turn back: its momentum is a "
                "function of it\n  p_s = (- alpha_s (expt s 2))")
 (separation-actions (separate-Hamilton-Jacobi clocked (up 't (up 's 'x) (down 'p_s 'p)))
                     (up 0 (up 1 1) (down 0 0)))
 exn:fail:mechanics?)
