#lang racket/base
;; A student hands over one thing for another: Newton's force for a generalized one, an
;; equilibrium for its coordinates, a path without multipliers, functions of three arguments for
;; functions of the local tuple.  The complaints were Racket's, of an arity, and named nobody.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define (L (up t q v)) (- (* 1/2 'm (square v)) (* 1/2 'k (square q))))
(define state (up 't (up 'x 'y) (up 'vx 'vy)))
(define xy (up (literal-function 'x) (literal-function 'y)))
(define (wind t r v) (* -1 'b v))
(define circle (holonomic (lambda (t q) (- (square q) 1))))

(define (of-force who)
  (string-append
   who ": a force is a function of the local tuple (up t q v); given the procedure `wind`, "
   "which takes 3 arguments\n"
   "  of a force on particles, (F t r v), (generalized-force r F) makes one"))

(test-case "a force on particles is none on coordinates"
  (check-message (of-force "Lagrange-equations") (Lagrange-equations L #:force wind))
  (check-message (of-force "power-balance") (power-balance L #:force wind))
  (check-message (of-force "verify-conserved")
                 (verify-conserved L (Lagrangian->energy L) state #:force wind))
  (check-message (of-force "equilibria") (equilibria L state #:force wind))
  (check-message (of-force "constrained-accelerations")
                 ((constrained-accelerations L circle #:force wind) state))
  (check-message (of-force "Lagrangian->state-derivative")
                 ((Lagrangian->state-derivative L #:force wind) state)))

(test-case "of a function of two arguments no force is made"
  (define (f t q) q)
  (check-message (string-append "Lagrange-equations: a force is a function of the local tuple "
                                "(up t q v); given the procedure `f`, which takes 2 arguments")
                 (Lagrange-equations L #:force f)))

(test-case "multipliers are an argument"
  (check-message (string-append
                  "constrained-Lagrange-equations: the multipliers are missing; they are an "
                  "argument beside the path\n  constraints: (holonomic <function>)\n"
                  "  (eliminate-multipliers L constraints) makes equations without them")
                 ((constrained-Lagrange-equations L circle) xy)))

(test-case "an equilibrium has coordinates"
  (define rest (car (equilibria L (up 't 'x 'v))))
  (define (says who)
    (string-append who ": expected coordinates, a scalar or an up tuple of scalars\n"
                   "  given: (equilibrium 0)\n"
                   "  its coordinates are (equilibrium-coordinates e)"))
  (check-message (says "equilibrium-stability") (equilibrium-stability L rest))
  (check-message (says "normal-modes") (normal-modes L rest))
  (check-message (says "verify-equilibrium") (verify-equilibrium L rest)))

(test-case "functions of the local tuple take one argument"
  (define (f t q v) (* q v))
  (check-message
   (string-append "verify-total-time-derivative: expected a function of the local tuple "
                  "(up t q v); given the procedure `f`, which takes 3 arguments")
   (verify-total-time-derivative f (up 't 'x 'v)))
  (check-message (string-append "verify-conserved: a quantity is a function of the local tuple "
                                "(up t q v); given the procedure `f`, which takes 3 arguments")
                 (verify-conserved L f (up 't 'x 'v))))

(test-case "an equilibrium is looked for by numbers"
  (define text
    (string-append
     "find-equilibrium: symbols are left in the force on the system at rest\n  residual: ~a\n"
     "  give the Lagrangian numbers as parameters; equilibria finds formulas in symbols"))
  (define ((L-spring k) (up t x v)) (- (* 1/2 (square v)) (* 1/2 k (square (- x 2)))))
  (check-message (format text "(* -1 k)") (find-equilibrium (L-spring 'k) 1))
  (check-message (format text "(- x 2)") (find-equilibrium (L-spring 1) 'x))
  (check-= 2 (find-equilibrium (L-spring 1) 1) 1e-9))
