#lang racket/base
;; Exact results held 3.141592653589793 for π, in equilibria and in the zeros of
;; sines; a decimal near π was read as (acos -1), which nobody types; ':pi was a symbol like
;; any other.

(require racket/flonum
         mechanics
         (only-in mechanics/book L-harmonic)
         "../support/checks.rkt")

(define (shown x) (format "~a" x))

(define ((L-pendulum m l g) s)
  (+ (* 1/2 m l l (square (velocity s))) (* m g l (cos (coordinate s)))))

(define L (L-pendulum 'm 'l 'g))

(test-case "the equilibria of a pendulum are 0 and exactly π, and are proved to be"
  (define found (map equilibrium-coordinates (equilibria L (up 't 'theta 'thetadot))))
  (check-equal? (map expression found) '(0 :pi))
  (check-true (andmap (lambda (q) (proved? (verify-equilibrium L q))) found))
  (check-true (proved? (verify-equilibrium L (* 3 ':pi))))
  (check-true (proved? (verify-equilibrium L ':-pi)))
  (check-true (refuted? (verify-equilibrium L ':pi/2)))
  (check-true (refuted? (verify-equilibrium L (* 22/7 ':pi))))
  (check-equal? (map expression (small-oscillation-frequencies L (cadr found)))
                '((sqrt (/ (* -1 g) l))))
  (check-eq? (stability-kind (assuming ('(> m 0) '(> l 0) '(> g 0))
                               (equilibrium-stability L (cadr found))))
             'unstable))

(test-case "what is found by numbers stays a number"
  (check-= (find-equilibrium (L-pendulum 1 1 9.8) 3) pi 1e-12)
  (check-pred flonum? (find-equilibrium (L-pendulum 1 1 9.8) 3)))

(test-case "an exact equilibrium is where a motion may begin"
  (define (start q) (up 0 q 1/10))
  (define (derivative m l g) (Lagrangian->state-derivative (L-pendulum m l g)))
  (define (swing q) ((state-advancer derivative 1 1 9.8) (start q) 1/2))
  (check-= (ref (swing ':pi) 1) (ref (swing pi) 1) 1e-9))

(test-case "and a Lagrangian may hold it"
  (define (end k)
    ((state-advancer (lambda () (Lagrangian->state-derivative (L-harmonic 1 k)))) (up 0 1 0) 1))
  (check-= (ref (end (square ':pi)) 1) -1.0 1e-8)
  (check-= (ref (end (square ':2pi)) 1) 1.0 1e-8))

(test-case "with all its digits, where more are asked for than flonums have"
  (define (derivative) (Lagrangian->state-derivative (L-harmonic 1 (square ':2pi))))
  (define x (ref ((state-advancer derivative) (up 0 1 0) 1 #:precision 200) 1))
  (check-true (< (abs (- x 1)) 1e-40)))

(test-case "a decimal near π is read as :pi"
  (define v (prove-zero (- (sin (+ 'x (* 2 pi))) (sin 'x))))
  (check-true (proved? v))
  (check-regexp-match #rx"reading: 6.283185307179586 as \\(\\* 2 :pi\\)" (shown v))
  (check-true (proved? (prove-zero (- (cos (+ 'x (/ pi 2))) (- (sin 'x)))))))

(test-case "a number is made of it by exact->inexact, and by being compiled"
  (check-equal? (exact->inexact ':pi) pi)
  (check-equal? (exact->inexact (* 2 ':pi)) (* 2 pi))
  (check-equal? (exact->inexact (up ':pi/2 'x)) (up (/ pi 2) 'x))
  (define f (compile-function (lambda (x) (sin (* ':pi x))) 1.0))
  (check-equal? (compiled-function-reason f) #f)
  (check-= (flvector-ref (f (flvector 0.5)) 0) 1.0 1e-15)
  (check-= (definite-integral sin 0 ':pi) 2.0 1e-12))

(test-case "numbers meet it as they meet any expression"
  (check-equal? (expression (simplify (+ 1.0 ':pi))) '(+ 1 :pi))
  (check-equal? (expression (simplify (* 0.5 ':2pi))) ':pi)
  (check-equal? (expression (simplify (- ':pi ':pi/2))) '(* 1/2 :pi))
  (check-equal? (expression (simplify ':2pi)) '(* 2 :pi)))

(test-case "derivatives take it for the constant it is"
  (check-equal? (expression (simplify ((D (lambda (x) (sin (* ':pi x)))) 'x)))
                '(* :pi (cos (* :pi x))))
  (check-equal? (expression (simplify ((D sin) ':pi))) -1))

(test-case "what is printed reads back"
  (define q (equilibrium-coordinates (cadr (equilibria L (up 't 'theta 'thetadot)))))
  (check-equal? (format "~s" (simplify (* 2/3 q 'm))) "(* 2/3 :pi m)")
  (check-true (proved? (prove-zero (- (* 2/3 q 'm) (with-literals (m) (* 2/3 ':pi m)))))))
