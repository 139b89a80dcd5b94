#lang racket/base
;; Paths through given points, and their actions.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/value/structure
         mechanics/calculus/derivative
         mechanics/lagrangian/local-tuple
         mechanics/lagrangian/path
         (only-in mechanics/book L-free-particle L-harmonic)
         "../support/checks.rkt" "../support/random.rkt" "../support/same.rkt")

(test-case "points evenly spaced between two others"
  (check-equal? (linear-interpolants 0 1 3) '(1/4 1/2 3/4))
  (check-equal? (linear-interpolants 0 1 0) '())
  (check-equal? (linear-interpolants 1.0 -1.0 1) '(0.0))
  (check-true (same? (list->up (linear-interpolants 'a 'b 1)) (up (g:/ (g:+ 'a 'b) 2))))
  (check-exn #rx"^linear-interpolants: .*a number of points"
             (lambda () (linear-interpolants 0 1 1.5))))

(test-case "the interpolating polynomial goes through its points"
  (with-seed 501
    (for ([n (in-range 1 7)])
      (define xs (for/list ([i n]) (+ i (/ (random 10) 20))))
      (define ys (for/list ([i n]) (random-rational)))
      (define f (Lagrange-interpolation-function ys xs))
      (check-equal? (map f xs) ys))))

(test-case "it is the polynomial itself where the values are a polynomial's, derivatives included"
  (define (p x) (g:+ 3 (g:* -2 x) (g:expt x 3)))
  (define f (Lagrange-interpolation-function (map p '(0 1 2 5)) '(0 1 2 5)))
  (check-equal? (f 1/2) (p 1/2))
  (check-equal? ((D f) 2) 10)
  (check-true (same? (((g:expt D 2) f) 'x) (g:* 6 'x))))

(test-case "values may be tuples, points may be symbols"
  (define f (Lagrange-interpolation-function (list (up 0 1) (up 2 5)) '(0 1)))
  (check-equal? (f 1/2) (up 1 3))
  (check-true (same? ((Lagrange-interpolation-function '(a b) '(s u)) 's) 'a)))

(test-case "values and points must be as many"
  (check-exn
   #rx"^Lagrange-interpolation-function: expected as many values as points, and at least one"
   (lambda () (Lagrange-interpolation-function '(1 2) '(1))))
  (check-exn #rx"as many values as points" (lambda () (Lagrange-interpolation-function '() '()))))

(test-case "a path through its ends and the points between"
  (define path (make-path 0 'a 3 'd '(b c)))
  (for ([t '(0 1 2 3)] [q '(a b c d)])
    (check-true (same? (path t) q)))
  (check-equal? ((make-path 0 1 2 5 '()) 1) 3)
  (check-exn #rx"^make-path: .*a list of intermediate coordinates"
             (lambda () (make-path 0 1 2 5 3))))

(test-case "a variation vanishes at both ends"
  (define eta (make-eta (up g:sin g:cos) 1 3))
  (check-true (same? (eta 1) (up 0 0)))
  (check-true (same? (eta 3) (up 0 0)))
  (check-true (same? (eta 't) (g:* (g:- 't 1) (g:- 't 3) (up (g:sin 't) (g:cos 't)))))
  (check-exn #rx"^make-eta: .*a function of time" (lambda () (make-eta 3 0 1))))

(test-case "the action of a path as a function of its points (SICM p. 21)"
  ;; the points of the straight line make the action of a free particle least
  (define action (parametric-path-action (L-free-particle 2) 0 0 1 1))
  (check-= (action '(1/3 2/3)) 1 1e-12)
  (check-true (> (action '(0.3 2/3)) (action '(1/3 2/3))))
  (define oscillator (parametric-path-action (L-harmonic 1 1) 0 1 (acos 0.0) 0))
  (define (error-with points)
    (define path (make-path 0 1 (acos 0.0) 0 points))
    (for/fold ([worst 0]) ([t (in-range 0 1.6 0.1)]) (max worst (abs (- (path t) (cos t))))))
  (define exact-points (map cos (linear-interpolants 0 (acos 0.0) 3)))
  (check-true (< (error-with exact-points) 5e-4))
  (check-= (oscillator exact-points) 0 1e-5))

(test-case "each path and its action can be observed (exercise 1.5)"
  (define seen '())
  (define (observe path action) (set! seen (cons (cons (path 1/2) action) seen)))
  (define action (parametric-path-action (L-free-particle 2) 0 0 1 1 #:observe observe))
  (define values (map action '((1/2) (1/4))))
  (check-equal? (reverse seen) (map cons '(1/2 1/4) values)))

(test-case "of Lagrangians with accelerations as well"
  (define (L local) (g:square (acceleration local)))
  (define action (parametric-path-action L 0 0 1 1 #:order 2))
  (check-= (action '(1/2)) 0 1e-12)
  ;; the parabola through (0, 0), (1/2, 1/4), (1, 1) has the acceleration 2
  (check-= (action '(1/4)) 4 1e-12))
