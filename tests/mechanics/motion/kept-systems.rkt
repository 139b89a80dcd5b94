#lang racket/base
;; Code compiled for a state derivative is used again, and never when it is stale.

(require mechanics
         (only-in mechanics/book L-harmonic)
         (only-in mechanics/motion/system/kept-systems clear-kept-systems)
         (only-in mechanics/motion/system/make-system make-system)
         "../support/checks.rkt")

(define start (up 0 1 0))

(define (final derivative [state start])
  (trajectory-final-state (evolve-trajectory derivative state 1)))
(define (position derivative) (coordinate (final derivative)))

(define (check-again derivative state)
  (define one (make-system 'test derivative state))
  (check-eq? (make-system 'test derivative state) one)
  one)

(test-case "the system of a state derivative is made once, for any state of its shape"
  (define k 2)
  (define (spring s) (up 1 (velocity s) (* -1 k (coordinate s))))
  (define one (check-again spring start))
  (check-eq? (make-system 'test spring (up 3.0 -1 1/2)) one)
  (check-false (eq? (make-system 'test spring (up 0 (up 1 2) (up 0 0))) one))
  (check-eq? (make-system 'test spring start) one)
  (check-again (Lagrangian->state-derivative (L-harmonic 1 k)) start)
  (clear-kept-systems)
  (check-false (eq? (make-system 'test spring start) one)))

(test-case "those of the latest four shapes are kept"
  (define (spring s) (up 1 (velocity s) (- (coordinate s))))
  (define (system n)
    (define (tuple x) (apply up (for/list ([_ n]) x)))
    (make-system 'test spring (up 0 (tuple 1) (tuple 0))))
  (define made (for/list ([n '(1 2 3 4 5)]) (system n)))
  (for ([n '(5 4 3 2)]) (check-eq? (system n) (list-ref made (- n 1))))
  (check-false (eq? (system 1) (car made))))

(test-case "a variable that was set anew is noticed"
  (define k 1)
  (define (spring s) (up 1 (velocity s) (* -1 k (coordinate s))))
  (define (L s) (- (* 1/2 (square (velocity s))) (* 1/2 k (square (coordinate s)))))
  (define of-Lagrangian (Lagrangian->state-derivative L))
  (for ([value '(1 4 1 9/4 2.25 (+ 1/4 0.0000001))])
    (define x (if (pair? value) 0.2500001 value))
    (set! k x)
    (check-= (position spring) (cos (sqrt x)) 1e-8)
    (check-= (position of-Lagrangian) (cos (sqrt x)) 1e-8)))

(test-case "the last digits of it, too; and in a big system"
  (define m 1.0)
  (define (L s)
    (- (* 1/2 m (square (velocity s))) (* 1/2 (square (coordinate s)))))
  (define derivative (Lagrangian->state-derivative L))
  (define (tuple x) (apply up (for/list ([k 7]) x)))
  (define state (up 0 (tuple 1.0) (tuple 0.0)))
  (define one (check-again derivative state))
  (set! m (+ 1.0 (expt 2.0 -50)))
  (define other (check-again derivative state))
  (check-false (eq? one other))
  (set! m 4)
  (check-= (ref (coordinate (final derivative state)) 3) (cos 1/2) 1e-8))

(test-case "so are a parameter, a box, a vector and a table; a function that counts is refused"
  (define parameter (make-parameter 1))
  (define b (box 1))
  (define v (vector 1 1))
  (define table (make-hash '((k . 1))))
  (define (spring k) (lambda (s) (up 1 (velocity s) (* -1 (k) (coordinate s)))))
  (define by-parameter (spring parameter))
  (check-= (position by-parameter) (cos 1) 1e-8)
  (parameterize ([parameter 4]) (check-= (position by-parameter) (cos 2) 1e-8))
  (check-= (position by-parameter) (cos 1) 1e-8)
  (for ([k (list (lambda () (unbox b)) (lambda () (vector-ref v 1))
                 (lambda () (hash-ref table 'k)))]
        [change! (list (lambda () (set-box! b 4)) (lambda () (vector-set! v 1 4))
                       (lambda () (hash-set! table 'k 4)))])
    (define derivative (spring k))
    (check-= (position derivative) (cos 1) 1e-8)
    (change!)
    (check-= (position derivative) (cos 2) 1e-8))
  (define count 0)
  (define (counting)
    (set! count (+ count 1))
    count)
  (define derivative (spring counting))
  (check-exn #rx"gives other values each time" (lambda () (make-system 'test derivative start))))

(test-case "what decides by numbers is not kept"
  (define slope 1)
  (define (kinked s) (up 1 (velocity s) (if (< (coordinate s) 100) 0 slope)))
  (check-false (eq? (make-system 'test kinked start) (make-system 'test kinked start))))

(test-case "a start that is none is still refused in its own words"
  (define (L s) (* 1/2 (square (coordinate s)) (square (velocity s))))
  (define f (Lagrangian->state-derivative L))
  (check-again f (up 0 1 1))
  (check-exn #rx"no inertia" (lambda () (make-system 'test f (up 0 0 1))))
  (check-exn #rx"the symbol a" (lambda () (make-system 'test f (up 0 1 'a)))))

(test-case "a change is seen beside a large constant"
  (define k 1)
  (define (L s)
    (- (* 1/2 (square (velocity s))) (* 1/2 k (square (coordinate s))) 1e20))
  (define f (Lagrangian->state-derivative L))
  (check-= (position f) (cos 1) 1e-8)
  (set! k 4)
  (check-= (position f) (cos 2) 1e-8))

(test-case "nothing is kept alive"
  (define derivative (let ([k (random)]) (lambda (s) (up 1 (* k (ref s 1))))))
  (define held (make-weak-box derivative))
  (void (make-system 'test derivative (up 0 1)))
  (set! derivative #f)
  (collect-garbage)
  (check-false (weak-box-value held)))
