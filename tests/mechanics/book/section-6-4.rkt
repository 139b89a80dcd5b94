#lang racket/base
;; SICM 6.4 and 7.2: Lie series, with the Lie derivative written as in the book.

(require mechanics
         rackunit
         "../support/session.rkt")

(define (bracket F G)
  (- (* ((partial 1) F) ((partial 2) G)) (* ((partial 2) F) ((partial 1) G))))
(define ((Lie-derivative-procedure H) F) (bracket F H))
(define (Lie-of H) (make-operator (Lie-derivative-procedure H) (list 'Lie-derivative H)))
(define (Lie-transform-of H t) (exp (* t (Lie-of H))))

(define ((H-harmonic m k) (up t q p))
  (+ (/ (square p) (* 2 m)) (* 1/2 k (square q))))

(test-case "p. 448: the Lie series of x for the harmonic oscillator"
  (define terms
    (((Lie-transform-of (H-harmonic 'm 'k) 'dt) coordinate) (up 0 'x0 'p0)))
  (define seen '())
  (series:for-each (lambda (term) (set! seen (cons term seen))) terms 6)
  (for ([term (reverse seen)]
        [expected '(x0
                    (/ (* dt p0) m)
                    (/ (* -1/2 (expt dt 2) k x0) m)
                    (/ (* -1/6 (expt dt 3) k p0) (expt m 2))
                    (/ (* 1/24 (expt dt 4) (expt k 2) x0) (expt m 2))
                    (/ (* 1/120 (expt dt 5) (expt k 2) p0) (expt m 3)))])
    (check-prints term expected)))

(test-case "p. 448: its sum is the motion"
  (define s (((Lie-transform-of (H-harmonic 2.0 8.0) 0.1) coordinate) (up 0 1.0 3.0)))
  (check-= (series:sum s 8) (+ (cos 0.2) (* 3/4 (sin 0.2))) 1e-9))

(test-case "p. 449: a function of the state along the central motion, two orders"
  (define ((H-central m V) (up t (up r phi) (down p_r p_phi)))
    (+ (/ (+ (square p_r) (square (/ p_phi r))) (* 2 m)) (V r)))
  (define state (up 0 (up 'r_0 'phi_0) (down 'p_r_0 'p_phi_0)))
  (define s
    (((Lie-transform-of (H-central 'm (literal-function 'U)) 'dt) coordinate) state))
  (check-prints (series:ref s 0) '(up r_0 phi_0))
  (check-prints (series:ref s 1)
                '(up (/ (* dt p_r_0) m) (/ (* dt p_phi_0) (* m (expt r_0 2)))))
  (check-prints (ref s 2 1) '(/ (* -1 (expt dt 2) p_phi_0 p_r_0) (* (expt m 2) (expt r_0 3)))))

;; ---------------------------------------------------------------------------
;; 7.2: the pendulum as a perturbed rotor

(define ((H0 alpha) (up t theta p)) (/ (square p) (* 2 alpha)))
(define ((H1 beta) (up t theta p)) (* -1 beta (cos theta)))
(define (H-series alpha beta epsilon) (series (H0 alpha) (* epsilon (H1 beta))))
(define ((W alpha beta) (up t theta p)) (/ (* -1 alpha beta (sin theta)) p))

(define a-state (up 't 'theta 'p))
(define H (H-series 'alpha 'beta 'epsilon))
(define L (Lie-of (W 'alpha 'beta)))

(test-case "p. 462: the generator removes the first order"
  (check-prints ((+ (L (H0 'alpha)) (H1 'beta)) a-state) 0))

(test-case "p. 463: the Hamiltonian transformed, to the second order"
  (define transformed (((exp (* 'epsilon L)) H) a-state))
  (check-prints (series:ref transformed 1) 0)
  (check-prints (series:sum transformed 2)
                '(+ (/ (* 1/2 (expt p 2)) alpha)
                    (/ (* 1/2 alpha (expt beta 2) (expt epsilon 2) (expt (sin theta) 2))
                       (expt p 2)))))

(test-case "p. 463: a transform and its inverse undo each other, order by order"
  (define there (exp (* 'epsilon L)))
  (define back (exp (* -1 'epsilon L)))
  (define s (((* there back) coordinate) a-state))
  (check-prints (list->up (series:head s 4)) '(up theta 0 0 0)))
