#lang racket/base
;; How often motions are compiled, and that nothing stale or cut short is followed.

(require (only-in racket/base [< racket:<] [= racket:=] [case racket:case])
         mechanics
         mechanics/compile/cache
         (only-in mechanics/book L-pendulum)
         "../support/checks.rkt")

(define (pendulum m l g) (Lagrangian->state-derivative (L-pendulum g m l)))
(define start (up 0 1 0))

(define-syntax-rule (compilations body ...)
  (begin
    (clear-compiled-programs)
    body ...
    (compiled-program-count)))

(test-case "a sweep of a parameter compiles once"
  (define expected
    (for/list ([l '(1 3/2 2.0 2.5 7)]) ((state-advancer (lambda () (pendulum 1 l 9.8))) start 1)))
  (define swept '())
  (check-equal?
   (compilations
    (set! swept
          (for/list ([l '(1 3/2 2.0 2.5 7)]) ((state-advancer pendulum 1 l 9.8) start 1))))
   1)
  (for ([s swept] [e expected])
    (check-= (coordinate s) (coordinate e) 1e-12)))

(test-case "parameters may be tuples, beside others that are no numbers"
  (define ((falling ms force) s)
    (define a (/ (force (ref (coordinate s) 0)) (+ (ref ms 0) (* 2 (ref ms 1 0)))))
    (up 1 (velocity s) (up a (* (ref ms 1 1) (ref (coordinate s) 1)))))
  (define (spring x) (* -3 x))
  (define state (up 0 (up 1 2) (up 0 1)))
  (define (tuple m) (up m (down (* 2 m) -1)))
  (define swept '())
  (check-equal?
   (compilations
    (set! swept (for/list ([m '(1 1/2 3.0)]) ((state-advancer falling (tuple m) spring) state 1))))
   1)
  (for ([s swept] [m '(1 1/2 3.0)])
    (check-= (ref (coordinate s) 0) (cos (sqrt (/ 3 (* 5 m)))) 1e-9)
    (check-= (ref (coordinate s) 1) (+ (* 2 (cos 1)) (sin 1)) 1e-9)))

(test-case "a parameter that is a vector or a list is what it was"
  (define ((weighed ws) s) (up 1 (velocity s) (* -1 (vector-ref ws 1) (coordinate s))))
  (define ((listed ws) s) (up 1 (velocity s) (* -1 (cadr ws) (coordinate s))))
  (define (expected w) (cos (sqrt w)))
  (for ([w '(2 3)])
    (check-= (coordinate ((state-advancer weighed (vector 1 w)) start 1)) (expected w) 1e-9)
    (check-= (coordinate ((state-advancer listed (list 1 w)) start 1)) (expected w) 1e-9)))

(test-case "an advancer compiles once for a shape of state, however many it meets"
  (define (harmonic k) (lambda (s) (up 1 (velocity s) (* -1 k (coordinate s)))))
  (define advance (state-advancer harmonic 2))
  (check-equal?
   (compilations
    (for ([q '(1 2 3)]) (advance (up 0 q 1) 1))
    (for ([q '(1 2 3)]) (advance (up 0 (up q 2) (up 1 1)) 1))
    (for ([q '(1 2 3)]) (advance (up 0 q 1) 1)))
   2))

(test-case "evolve and evolve-trajectory share what state-advancer compiled"
  (check-equal?
   (compilations
    ((state-advancer (lambda () (pendulum 1 1 9.8))) start 1)
    ((evolve (lambda () (pendulum 1 1 9.8))) start void 0.1 1)
    (evolve-trajectory (pendulum 1 1 9.8) start 1))
   1))

(test-case "a parameter that decides is compiled for each way"
  (define ((pushed mode) s) (up 1 (velocity s) (if (= mode 1) 1 (* -1 (coordinate s)))))
  (define (after mode) (coordinate ((state-advancer pushed mode) (up 0 0 0) 2)))
  (check-= (after 1) 2 1e-10)
  (check-= (after 2) 0 1e-10)
  (check-= (after 1.0) 2 1e-10))

(test-case "parameters keep the exactness they were given, whoever looks at them"
  (define-syntax-rule (check-modes derivative)
    (let ()
      (define (after mode) (coordinate ((state-advancer derivative mode) (up 0 0 1) 1 1e-12)))
      (check-= (after 1) (- 1 (exp -1)) 1e-11)
      (check-= (after 2) 1 1e-11)))
  (define ((by-match mode) s)
    (up 1 (velocity s) (match mode [1 (- (velocity s))] [_ 0])))
  (define ((by-case mode) s)
    (up 1 (velocity s) (racket:case mode [(1) (- (velocity s))] [else 0])))
  (define ((by-table mode) s)
    (up 1 (velocity s) (* (hash-ref (hash 1 -1 2 0) mode 0) (velocity s))))
  (define ((by-exactness mode) s)
    (up 1 (velocity s) (if (and (exact-integer? mode) (racket:= mode 1)) (- (velocity s)) 0)))
  (check-modes by-match)
  (check-modes by-case)
  (check-modes by-table)
  (check-modes by-exactness))

(test-case "a decision by the state that no trace sees"
  (define ((wall k) s)
    (define x (coordinate s))
    (up 1 (velocity s) (if (and (real? x) (racket:< x 0)) (* -1 k x) -1)))
  (define s ((state-advancer wall 1000) (up 0 0.5 0) 2 1e-10))
  (define x (coordinate s))
  (check-= (+ (* 1/2 (square (velocity s))) (if (< x 0) (* 500 (square x)) x)) 0.5 1e-7))

(test-case "a global that has changed is seen by what is built afterwards, and by that alone"
  (define g 2)
  (define (falling) (lambda (s) (up 1 (velocity s) (- g))))
  (define before (state-advancer falling))
  (check-= (velocity (before (up 0 0 0) 1)) -2 1e-12)
  (set! g 3)
  (check-= (velocity ((state-advancer falling) (up 0 0 0) 1)) -3 1e-12)
  (check-= (velocity (trajectory-final-state (evolve-trajectory (falling) (up 0 0 0) 1))) -3 1e-12)
  (set! g (lambda (s) (time s)))
  (define (pushed) (lambda (s) (up 1 (velocity s) (g s))))
  (check-= (velocity ((state-advancer pushed) (up 0 0 0) 1)) 1/2 1e-12))
