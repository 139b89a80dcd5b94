#lang racket/base
;; Lagrangians, paths and forces of the wrong kind gave messages about arity, or
;; about arithmetic deep in the residual.

(require mechanics
         (only-in mechanics/book L-free-particle)
         "../support/checks.rkt" "../support/messages.rkt")

(define x (literal-function 'x))
(define y (literal-function 'y))

(test-case "a Lagrangian of three arguments is told to take one"
  (define (L t q v) (square v))
  (check-exn
   #rx"but L does not.\n  If it takes the time, coordinates and velocities, write them as one argument: [(]up t q v[)]\n"
   (lambda () (Lagrange-equations L)))
  (define (L-two m k) m)
  (check-exn #rx"but L-two does not.\n  If it takes parameters first"
             (lambda () (Lagrange-equations L-two))))

(test-case "a path and a time at once"
  (check-message
   "Lagrange-equations: the equations take one argument, a path, but got 2; the time comes next: (((Lagrange-equations L-free-particle) x) 't)"
   ((Lagrange-equations (L-free-particle 'm)) x 't))
  (check-exn exn:fail:contract:arity? (lambda () ((Lagrange-equations (L-free-particle 'm))))))

(test-case "parameters left out are noticed wherever a Lagrangian is used"
  (define hint "was a parameter left out, as the mass in [(]L-free-particle 'm[)][?]$")
  (define (check-hint who thunk)
    (check-exn
     (lambda (e)
       (and (regexp-match? (string-append "^" who ": the value of a Lagrangian is a number")
                           (exn-message e))
            (regexp-match? hint (exn-message e))))
     thunk))
  (define (L m) (L-free-particle m))
  (check-hint "Lagrangian-action" (lambda () (Lagrangian-action L sin 0 1)))
  (check-hint "Lagrangian->energy" (lambda () ((Lagrangian->energy L) (up 't 'x 'v))))
  (check-hint "Lagrangian->acceleration" (lambda () ((Lagrangian->acceleration L) (up 't 'x 'v))))
  (check-hint "Euler-Lagrange-operator" (lambda () ((Euler-Lagrange-operator L) (up 't 'x 'v 'a)))))

(test-case "a path and a Lagrangian in the wrong order"
  (for ([path (list x sin (lambda (t) (up t t)))])
    (check-message "verify-solution: the Lagrangian comes first, then the path; these look swapped"
                   (verify-solution path (L-free-particle 'm))))
  (check-exn #rx"^verify-solution: a path is"
             (lambda () (verify-solution (L-free-particle 'm) 'x))))

(test-case "a force is of the shape of the momenta, or 0"
  (define ((residual force) path)
    (((Lagrange-equations (L-free-particle 'm) #:force (lambda (local) force)) path) 't))
  (check-message
   "Lagrange-equations: the force must be a down tuple of 2, like the momenta; given the number 3"
   ((residual 3) (up x y)))
  (check-message
   "Lagrange-equations: the force must be a down tuple of 2, like the momenta; given (up 3 4), an up tuple of 2"
   ((residual (up 3 4)) (up x y)))
  (check-message
   "Lagrange-equations: the force must be a number, like the momenta; given (down 3), a down tuple of 1"
   ((residual (down 3)) x))
  (check-true (proved? (prove-zero (- ((residual 0) (up x y)) ((residual (down 0 0)) (up x y))))))
  (check-true (proved? (prove-zero (- ((residual 'F) x) ((residual 0) x) (- 'F))))))

(test-case "a path takes one argument, all the way down"
  (define (f t s) t)
  (check-message
   "Gamma: a path is a function of time, or a tuple of such functions; given the procedure `f`\n  a path takes one argument, the time; this takes 2 arguments"
   (Gamma f))
  (check-exn #rx"\n  its component 1 is .*\n  a path takes one argument"
             (lambda () (Gamma (up x (up y f)))))
  (check-exn #rx"\n  its component 1 is the number 2; a constant path is [(]lambda [(]t[)] 2[)]$"
             (lambda () (Gamma (up x 2))))
  (check-exn #rx"\n  its component 0 is the symbol a; a constant path is [(]lambda [(]t[)] 'a[)]$"
             (lambda () (Gamma (up 'a x))))
  (check-exn #rx"^Lagrangian-action: a path is"
             (lambda () (Lagrangian-action (L-free-particle 1) 'x 0 1))))
