#lang racket/base
;; Motion in numbers of higher precision, and what it says of long runs in flonums.

(require (except-in rackunit fail)
         mechanics
         "../runner/bigfloats.rkt" "../runner/skip.rkt")

(define (scalars-of s)
  (if (structure? s) (apply append (map scalars-of (structure->list s))) (list s)))

(define-check (check-state s expected tolerance)
  (define given (scalars-of s))
  (unless (and (= (length given) (length expected))
               (for/and ([x given] [y expected]) (< (abs (- (exact x) (exact y))) tolerance)))
    (with-check-info (['given s] ['expected expected]) (fail-check))))

(define (exact x) (if (bigfloat? x) (bigfloat->exact x) (inexact->exact x)))

;; ---------------------------------------------------------------------------
;; Systems

(define ((harmonic ω) (up t x v)) (up 1 v (* -1 (square ω) x)))

(define ((L-driven-pendulum m l g ys) (up t θ v))
  (+ (* 1/2 m (+ (square (* l v)) (square ((D ys) t)) (* 2 l v ((D ys) t) (sin θ))))
     (* m g l (cos θ))
     (- (* m g (ys t)))))
(define (driven-pendulum m l g a ω)
  (Lagrangian->state-derivative
   (L-driven-pendulum m l g (lambda (t) (* a (cos (* ω t)))))))

(define ((L-double-pendulum m1 m2 l1 l2 g) (up t (up a b) (up va vb)))
  (+ (* 1/2 (+ m1 m2) (square (* l1 va)))
     (* 1/2 m2 (square (* l2 vb)))
     (* m2 l1 l2 va vb (cos (- a b)))
     (* (+ m1 m2) g l1 (cos a))
     (* m2 g l2 (cos b))))

;; A free rigid body in Euler's angles.
(define ((L-rigid A B C) (up t (up θ φ ψ) (up θ* φ* ψ*)))
  (define a (+ (* φ* (sin θ) (sin ψ)) (* θ* (cos ψ))))
  (define b (- (* φ* (sin θ) (cos ψ)) (* θ* (sin ψ))))
  (define c (+ (* φ* (cos θ)) ψ*))
  (* 1/2 (+ (* A (square a)) (* B (square b)) (* C (square c)))))

(define ((chain n) s)
  (define θ (coordinate s))
  (define-values (points x y)
    (for/fold ([points '()] [x 0] [y 0]) ([i n])
      (let ([x (+ x (sin (ref θ i)))] [y (- y (cos (ref θ i)))])
        (values (cons (up x y) points) x y))))
  (apply up (reverse points)))
(define (L-chain n)
  (compose (lambda (s)
             (for/sum ([r (coordinate s)] [v (velocity s)])
               (- (* 1/2 (square v)) (* 10 (ref r 1)))))
           (F->C (chain n))))

;; ---------------------------------------------------------------------------

(skip-unless bigfloats? no-bigfloats
  (define advance-harmonic (state-advancer harmonic 1))

  (test-case "the harmonic oscillator to fifty digits"
    (define T (bigfloat 10 200))
    (check-state (advance-harmonic (up 0 1 0) 10 #:precision 200)
                 (list 10 (cos T) (- (sin T)))
                 1e-50)
    (check-equal? (bigfloat-precision (time (advance-harmonic (up 0 1 0) 1 #:precision 200))) 200))

  (test-case "the error falls with the precision"
    (for/fold ([last 1]) ([bits '(64 100 200 400)])
      (define T (bigfloat 3 (* 2 bits)))
      (define x (coordinate (advance-harmonic (up 0 1 0) 3 #:precision bits)))
      (define error (abs (- (exact x) (exact (cos T)))))
      (check-true (< error (* 10 (expt 10 (- (quotient bits 4))))) (format "~a bits" bits))
      (check-true (< error last) (format "~a bits" bits))
      error))

  (test-case "the driven pendulum, to all printed digits (p. 76)"
    (define ω (* 2 (sqrt (bigfloat 98/10 200))))
    (define advance (state-advancer driven-pendulum 1 1 98/10 1/10 ω))
    (check-state (advance (up 0 1 0) 1 1e-25 #:precision 100)
                 '(1 #e-1.03011568739188687 #e-1.40985359335821735) 5e-18)
    (check-state (advance (up 0 1 0) 10 1e-25 #:precision 100)
                 '(10 #e1.27379225442614696 #e-3.45379718978431025) 5e-18))

  (test-case "when a run of the driven pendulum in flonums is no longer to be believed"
    (define ω (* 2 (sqrt (bigfloat 98/10 200))))
    (define flonums
      (evolve-trajectory (driven-pendulum 1 1 9.8 0.1 (* 2 (sqrt 9.8))) (up 0 1 0) 100
                         #:tolerance 1e-13))
    (define wrong
      (let/ec return
        ((evolve driven-pendulum 1 1 98/10 1/10 ω) (up 0 1 0)
         (lambda (s)
           (when (> (abs (- (coordinate s) (coordinate (flonums (time s))))) 0.1)
             (return (exact->inexact (time s)))))
         2 100 1e-16 #:precision 70)
        #f))
    (check-true (and wrong (< 60 wrong 100)) (format "~a" wrong)))

  (test-case "the double pendulum (exercise 1.44)"
    (define advance
      (state-advancer (lambda parameters
                        (Lagrangian->state-derivative (apply L-double-pendulum parameters)))
                      1 3 1 9/10 98/10))
    (define π (acos (bigfloat -1 200)))
    (define s1 (advance (up 0 (up (/ π 2) π) (up 0 0)) 1 1e-22 #:precision 90))
    (check-state s1
                 '(1 #e.0910630038849611 #e-1.66626245247204
                     #e-5.1832373624753 #e-4.02581660181084)
                 5e-14)
    (check-state (advance s1 4 1e-20 #:precision 90)
                 '(5 #e6.82360398985888 #e8.60368993913788 #e-3.01497306538466 #e3.79006470284155)
                 1e-14))

  (test-case "the free rigid body after t = 100 (p. 145)"
    (define L (L-rigid 1 (sqrt (bigfloat 2 100)) 2))
    (check-state
     ((state-advancer (lambda () (Lagrangian->state-derivative L)))
      (up 0 (up 1 0 0) (up 1/10 1/10 1/10)) 100 1e-15 #:precision 64)
     '(100 #e.6319896958326486 #e1.361027154088125 #e17.43790048473838
           #e-.1234371619718829 #e.09016109524795829 #e.07567921658610047)
     5e-15))

  (test-case "four links: their mass matrix is eliminated in all digits"
    (define E (Lagrangian->energy (L-chain 4)))
    (define (all x) (apply up (for/list ([i 4]) x)))
    (define start (up 0 (all 1) (all (bigfloat 0 120))))
    (define end
      ((state-advancer (lambda () (Lagrangian->state-derivative (L-chain 4))))
       start 1/4 1e-25 #:precision 120))
    (define before (E (up 0 (all (bigfloat 1 120)) (all 0))))
    (check-true (< (abs (- (E end) before)) 1e-23)))

  (test-case "a decision is followed, and a captured number is not rounded"
    (define k (bigfloat 1/3 200))
    (define ((by-halves) (up t x v)) (up 1 v (if (< x 10) (* 2 k) 0)))
    (define ((plain) (up t x v)) (up 1 v (* 2 k)))
    (for ([f (list by-halves plain)])
      (check-state ((state-advancer f) (up 0 0 0) 2 #:precision 150) '(2 4/3 4/3) 1e-35)))

  (test-case "the monitor sees exact times, forwards and backwards"
    (define seen '())
    (define (note s) (set! seen (cons (bigfloat->exact (time s)) seen)))
    (define last ((evolve harmonic 1) (up 0 1 0) note 3/10 1 #:precision 100))
    (check-equal? (map (lambda (t) (exact->inexact t)) (reverse seen)) '(0.0 0.3 0.6 0.9 1.0))
    (check-equal? (time last) (bigfloat 1 100))
    (set! seen '())
    ((evolve harmonic 1) (up 0 1 0) note 1/2 -1 #:precision 100)
    (check-equal? (reverse seen) '(0 -1/2 -1)))

  (test-case "a trajectory is as precise between steps as at their ends"
    (define tr (evolve-trajectory (harmonic 2) (up 0 1 0) 10 #:precision 200))
    (check-equal? (map exact (list (trajectory-start tr) (trajectory-end tr))) '(0 10))
    (for ([t (list 0 1/3 (bigfloat 2 200) 9.75 10)])
      (define T (* 2 (bigfloat t 200)))
      (check-state (tr t) (list t (cos T) (* -2 (sin T))) 1e-48))
    (check-exn #rx"trajectory: the time is outside the trajectory" (lambda () (tr 11)))
    (check-true (< 5 (length (trajectory-states tr)) 100)))

  (test-case "a parameter may set it for all"
    (parameterize ([ode-precision 100])
      (check-equal? (bigfloat-precision (coordinate (advance-harmonic (up 0 1 0) 1))) 100)
      (check-true (flonum? (coordinate (advance-harmonic (up 0 1 0) 1 #:precision #f))))))

  (test-case "numbers of higher precision enter a run in flonums rounded"
    (check-equal? (advance-harmonic (up 0 (bigfloat 1 100) 0) (bigfloat 1 100))
                  (advance-harmonic (up 0 1 0) 1)))

  (test-case "a singularity tells the time and the last state, and keeps the trajectory"
    (define (falling-in s) (up 1 (velocity s) (/ -1 (square (coordinate s)))))
    (define so-far
      (with-handlers ([exn:fail:mechanics:singular? exn:fail:mechanics:singular-where])
        (evolve-trajectory falling-in (up 0 1 0) 2 #:tolerance 1e-12 #:precision 64)))
    (define collision (/ (acos (bigfloat -1 64)) (* 2 (sqrt (bigfloat 2 64)))))
    (check-true (< (abs (- (trajectory-end so-far) collision)) 1e-8)))

  (test-case "an operation that only flonum code has is evaluated"
    (define ((turning) (up t x)) (up 1 (cos (* 1/3 ((principal-value :pi) x)))))
    (define advance (state-advancer turning))
    (check-= (bigfloat->exact (ref (advance (up 0 4) 1/2 1e-20 #:precision 100) 1))
             (ref (advance (up 0 4) 1/2 1e-14) 1)
             1e-13))

  (test-case "mistakes"
    (define (advance . more)
      (keyword-apply advance-harmonic '(#:precision) '(100) (list* (up 0 1 0) 1 more)))
    (check-exn #rx"state-advancer: the tolerance is below the rounding error of 100 bits, about 1e-30"
               (lambda () (advance 1e-40)))
    (check-exn #rx"state-advancer: methods are for flonums; with a precision, extrapolation integrates"
               (lambda () (advance-harmonic (up 0 1 0) 1 #:precision 100 #:method 'qcrk4)))
    (check-exn #rx"evolve-trajectory: events are found in flonums, not with a precision"
               (lambda () (evolve-trajectory (harmonic 1) (up 0 1 0) 1 #:precision 100
                                             #:events (event coordinate))))
    (check-exn #rx"expected a state of real numbers; the symbol x is none"
               (lambda () (advance-harmonic (up 0 'x 0) 1 #:precision 100)))
    (check-exn #rx"of another shape than the state"
               (lambda () ((state-advancer (lambda () (lambda (s) (up 1 2)))) (up 0 1 0) 1
                                                                             #:precision 100)))
    (check-exn #rx"evolve: the first component of the state is not the time"
               (lambda () ((evolve (lambda () (lambda (s) (up 2 1)))) (up 0 1) void 1 2
                                                                     #:precision 100)))))

(test-case "a precision is a number of bits"
  (check-exn #rx"ode-precision: contract violation\n  expected: a number of bits from 54 on, or #f for flonums\n  given: 20"
             (lambda () (ode-precision 20)))
  (check-exn #rx"state-advancer: contract violation\n  expected: a number of bits"
             (lambda () ((state-advancer harmonic 1) (up 0 1 0) 1 #:precision 1e-20))))
