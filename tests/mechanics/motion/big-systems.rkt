#lang racket/base
;; Systems of many coordinates: their rates from the Lagrangian's own instructions.

(require racket/flonum
         mechanics
         (only-in mechanics/motion/system/Lagrangian-code Lagrangian-code)
         (only-in mechanics/motion/system/make-system make-system)
         (only-in mechanics/motion/system/system system-operations)
         (only-in mechanics/value/shape structure->flvector flvector->structure shape-length)
         "../support/checks.rkt" (only-in "../support/systems.rkt" L-chain))

(define (code L state) (Lagrangian-code 'test (Lagrangian->state-derivative L) state))

(define (random-vector n) (for/flvector #:length n ([_ (in-range n)]) (- (random) 0.5)))

;; The rates are those of the generic arithmetic, at random states.
(define (check-rates L example)
  (define f (Lagrangian->state-derivative L))
  (define c (code L example))
  (for ([_ (in-range 3)])
    (define v (random-vector (shape-length example)))
    (define expected (structure->flvector (f (flvector->structure example v)) raise))
    (for ([x (in-flvector (c v))] [y (in-flvector expected)])
      (check-= x y (* 1e-10 (+ 1 (abs y)))))))

(define (flat-state n) (up 0.0 (vector->up (make-vector n 0.3)) (vector->up (make-vector n 0.1))))

(define (chain n) (L-chain n 9.8))

(random-seed 170)

(test-case "a chain, whose accelerations are those of the generic arithmetic"
  (check-rates (chain 7) (flat-state 7)))

(test-case "time, terms linear in the velocities, a kinetic energy that is no square"
  (define ((L n) (up t q v))
    (for/fold ([sum 0]) ([k (in-range n)])
      (define x (ref q k))
      (define next (ref q (modulo (+ k 1) n)))
      (+ sum
         (* (+ 1 (* 1/4 (sin (- x next)))) (sqrt (+ 1 (square (ref v k)))))
         (* t x (ref v (modulo (+ k 1) n)))
         (* (exp (* 1/10 t)) (cos (* x next)))
         (/ (square (ref v k)) (+ 2 (* x x))))))
  (check-rates (L 6) (flat-state 6)))

(test-case "coordinates in tuples of tuples, rows and columns"
  (define (L s)
    (define-values (q v) (values (coordinate s) (velocity s)))
    (+ (* 1/2 (square (ref v 0))) (* (ref v 1 0) (ref v 1 0) (+ 2 (sin (ref q 0 1))))
       (* 1/2 (square (ref v 1 1))) (* 3 (ref v 1 1) (ref v 0 2))
       (* -1 (ref q 0 0) (ref q 1 0) (ref q 1 1)) (* (square (ref q 0 2)) (ref q 1 2 0))
       (* 4 (square (ref v 1 2 0)))))
  (define (part a b c d e f) (up (up a b c) (down d e (up f))))
  (check-rates L (up 0.0 (part 0.1 0.2 0.3 0.4 0.5 0.6) (part 0.3 0.1 0.2 0.5 0.4 0.7))))

(test-case "few instructions: each coordinate takes some more, each pair a few"
  (define (operations n) (compiled-function-operations (code (chain n) (flat-state n))))
  (check-true (< (operations 20) (* 20 20 20)))
  (check-true (< (/ (operations 32) (operations 16)) 4.2))
  (define f (Lagrangian->state-derivative (chain 16)))
  (check-equal? (system-operations (make-system 'test f (flat-state 16))) (operations 16)))

(test-case "its motion is that of the generic way"
  (define n 6)
  (define f (Lagrangian->state-derivative (chain n)))
  (define (tuple x) (vector->up (make-vector n x)))
  (define start (up 0.0 (tuple 1.0) (tuple 0.0)))
  (define one (trajectory-final-state (evolve-trajectory f start 1 #:tolerance 1e-12)))
  (define other
    (trajectory-final-state (evolve-trajectory (lambda (s) (f s)) start 1 #:tolerance 1e-12)))
  (for ([x (in-flvector (structure->flvector one raise))]
        [y (in-flvector (structure->flvector other raise))])
    (check-= x y 1e-9)))

(test-case "what is not for it goes the other way"
  (define start (flat-state 6))
  (define (kinetic s) (* 1/2 (square (velocity s))))
  ;; a decision, a force, a few coordinates, a matrix that has no inverse
  (check-false (code (lambda (s) (if (< (ref s 0) 1) (kinetic s) (* 2 (kinetic s)))) start))
  (check-false (Lagrangian-code 'test (Lagrangian->state-derivative kinetic (lambda (s) 0)) start))
  (check-false (code (chain 3) (flat-state 3)))
  (define (flat s) (- (* 1/2 (square (ref (velocity s) 0))) (square (ref (coordinate s) 1))))
  (check-false (code flat start))
  (check-exn #rx"no inertia in the direction"
             (lambda () (evolve-trajectory (Lagrangian->state-derivative flat) start 1)))
  (check-exn #rx"the symbol k"
             (lambda ()
               (define (L s) (- (kinetic s) (* 'k (square (coordinate s)))))
               (evolve-trajectory (Lagrangian->state-derivative L) start 1))))
