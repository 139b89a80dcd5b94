#lang racket/base
;; Questions about all states were answered at special ones: where a symbol of the state was a
;; parameter of a force or of a constraint as well, or where the state was of numbers.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define (L (up t x v)) (* 1/2 (square v)))
(define (towards-v (up t x v)) (- 'v v))

(define (parameter name who owner)
  (string-append who ": the symbol " name " is a parameter of " owner
                 ", and stands in the local tuple, too\n"))
(define rename "  give one of them another name")

(define (shears t q v) (- (ref v 2) (* (- (ref q 1) 'y) (ref v 0))))
(define shearing (nonholonomic shears))

(define (turns t q v) (- (ref v 2) (* (ref q 1) (ref v 0))))
(define turning (nonholonomic turns))
(define (L-space (up t q v)) (* 1/2 (square v)))
(define (kept t q v) (up (ref v 0) (ref v 1) (* (ref q 1) (ref v 0))))

(says
 [(verify-conserved L velocity (up 't 'x 'v) #:force towards-v)
  (parameter "v" "verify-conserved" "towards-v") "  local tuple: (up t x v)\n" rename]
 [(equilibria L (up 't 'x 'v) #:force towards-v)
  (parameter "v" "equilibria" "towards-v") "  local tuple: (up t x v)\n" rename]
 [(Frobenius-test shearing (up 'x 'y 'z))
  (parameter "y" "Frobenius-test" "(nonholonomic shears)")
  "  local tuple: (up t (up x y z) (up v0 v1 v2))\n" rename]
 [(constraint-integral shearing (up 'x 'y 'z))
  (parameter "y" "constraint-integral" "(nonholonomic shears)")
  "  local tuple: (up t (up x y z) (up v0 v1 v2))\n" rename]
 [(reduce-by-substitution L-space turning kept (up 't (up 'x 'y 'z) (up 0 0 0)))
  "reduce-by-substitution: the local tuple must be made of symbols, each there once, "
  "to stand for any state\n  given: (up t (up x y z) (up 0 0 0))\n  no symbol: 0"])

(test-case "other names for the coordinates"
  (check-pred refuted? (verify-conserved L velocity (up 't 'x 'w) #:force towards-v))
  (check-pred refuted? (Frobenius-test shearing (up 'a 'b 'c)))
  (check-pred refuted?
              (reduction-agreement
               (reduce-by-substitution L-space turning kept
                                       (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz))))))
