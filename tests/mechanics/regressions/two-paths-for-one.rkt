#lang racket/base
;; Two coordinates given as two paths were taken for a path and a time, a length or a force, and
;; nothing said that they are one path, (up x y).

(require mechanics
         "../support/messages.rkt")

(define x (literal-function 'x))
(define y (literal-function 'y))
(define z (literal-function 'z))
(define (L (up t (up x y) (up vx vy))) (* 1/2 'm (+ (square vx) (square vy))))

(says
 [((Lagrange-equations L) x y)
  "Lagrange-equations: the equations take one argument, a path, but got 2\n"
  "  one path of both: ((Lagrange-equations L) (up x y))"]
 [((Lagrange-equations L) x y z)
  "Lagrange-equations: the equations take one argument, a path, but got 3\n"
  "  one path of all: ((Lagrange-equations L) (up x y z))"]
 [((Lagrange-equations L) (lambda (t) t) y)
  "Lagrange-equations: the equations take one argument, a path, but got 2\n"
  "  one path of both: ((Lagrange-equations L) (up x y))"]
 [((Lagrange-equations L) x 't)
  "Lagrange-equations: the equations take one argument, a path, but got 2; "
  "the time comes next: (((Lagrange-equations L) x) 't)"]
 [(((Lagrange-equations L) x) y)
  "Lagrange-equations: expected a time\n  given: y, a literal function (-> Real Real)\n"
  "  one path of both: ((Lagrange-equations L) (up x y))"]
 [(Gamma x y)
  "Gamma: expected the length of the local tuples, an integer of at least 2\n"
  "  given: y, a literal function (-> Real Real)\n"
  "  one path of both: (Gamma (up x y))"]
 [((Gamma x) y)
  "Gamma: expected a time\n  given: y, a literal function (-> Real Real)\n"
  "  one path of both: (Gamma (up x y))"]
 [((Gamma (up x y)) z)
  "Gamma: expected a time\n  given: z, a literal function (-> Real Real)"]
 [(verify-solution L x y)
  "verify-solution: a dissipation function takes the local tuple (up t q v); given y, "
  "a literal function (-> Real Real), which takes 1 argument\n"
  "  one path of several coordinates is a tuple of paths: (up x y)"]
 [(Lagrangian-action L x y 0 1)
  "Lagrangian-action: expected a time\n  given: y, a literal function (-> Real Real)\n"
  "  one path of both: (Lagrangian-action L (up x y) t1 t2)"])
