#lang racket/base
;; Under which conditions would the answer be another?  Verdicts tell every choice of
;; parameters with which the question keeps its meaning.

(require racket/string
         mechanics
         (only-in mechanics/book L-harmonic L-pendulum L-rotating-polar L-uniform-acceleration)
         "../support/checks.rkt" (only-in "../support/systems.rkt" L-Foucault))

(define (alternatives v)
  (for/list ([way (verdict-alternatives v)]) (map expression way)))

(define line (up 't 'x 'v))
(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))

(test-case "Foucault's pendulum: the rate of its plane, for both components together"
  (define (path t)
    (* 'a (cos (* 'w t)) (up (cos (* 'p t)) (sin (* 'p t)))))
  (define v (verify-solution (L-Foucault 'm 'k 'Omega 'beta) path))
  (check-equal? (map car (alternatives v)) '((= p (* -1 Omega (sin beta)))))
  (check-equal? (length (regexp-match* #rx"zero if:" (format "~a" v))) 1))

(test-case "angular momentum in a frame at rest, or at the equator"
  (define (momentum (up t (up x y) (up vx vy))) (- (* x vy) (* y vx)))
  (define v (verify-conserved (L-Foucault 'm 'k 'Omega 'beta) momentum plane))
  (check-equal? (alternatives v) '(((= Omega 0)) ((= (sin beta) 0))))
  (check-equal? (map expression (verdict-conditions v)) '((= Omega 0)))
  (check-true (string-contains? (format "~a" v)
                                "\n  zero if: Omega = 0\n  or if: (sin beta) = 0\n")))

(test-case "angular momentum in rotating coordinates is conserved if these are at rest"
  (define (momentum (up t (up r phi) (up rdot phidot))) (* 'm (square r) phidot))
  (check-equal? (alternatives (verify-conserved (L-rotating-polar 'm 'Omega) momentum polar))
                '(((= Omega 0)))))

(test-case "several symbols may have to be zero at once"
  (define (L (up t x v)) (+ (* 1/2 'm (square v)) (* 1/2 'm (square (* 'w x))) (* -1 'm 'g x)))
  (check-equal? (map (lambda (way) (sort way symbol<? #:key cadr))
                     (alternatives (verify-conserved L (lambda (l) (* 'm (velocity l))) line)))
                '(((= g 0) (= w 0)))))

(test-case "no mass is zero, and no length that the mass matrix needs"
  (define v (verify-conserved (L-pendulum 'g 'm 'l) velocity line))
  (check-equal? (alternatives v) '(((= g 0))))
  (check-equal? (alternatives (verify-solution (L-uniform-acceleration 'm 'g)
                                               (lambda (t) (up (* 'a t) (* 'b t)))))
                '(((= g 0)))))

(test-case "no amplitude is zero with which the path would stand still"
  (define v (verify-solution (L-harmonic 'm 'k) (lambda (t) (* 'A (cos (* 'omega t))))))
  (check-equal? (alternatives v) '(((= k (* m (expt omega 2))))))
  (check-equal? (alternatives (verify-solution (L-harmonic 'm 'k) (lambda (t) (* 'A t))))
                '(((= k 0)))))

(test-case "an amplitude with which something still moves"
  (check-equal? (alternatives (verify-solution (lambda (l) (* 1/2 'm (square (velocity l))))
                                               (lambda (t) (+ (* 'b t) (* 'c t t)))))
                '(((= c 0)))))

(test-case "no quantity that would be a constant"
  (check-equal? (alternatives (verify-conserved (L-harmonic 'm 'k)
                                                (lambda (l) (+ (* 'c (coordinate l)) 'b))
                                                line))
                '()))

(test-case "a friction that is none leaves the energy"
  (define L (L-harmonic 'm 'k))
  (check-equal? (alternatives (verify-conserved L (Lagrangian->energy L) line
                                                #:force (lambda (l) (* -1 'b (velocity l)))))
                '(((= b 0)))))

(test-case "nothing that was declared not to be zero"
  (define (momentum (up t (up r phi) (up rdot phidot))) (* 'm (square r) phidot))
  (check-equal? (assuming ('(> Omega 0))
                  (alternatives
                   (verify-conserved (L-rotating-polar 'm 'Omega) momentum polar)))
                '()))

(define (L-apart (up t (up x y) (up vx vy)))
  (- (* 1/2 (+ (* 'm_1 (square vx)) (* 'm_2 (square vy))))
     (* 1/2 (+ (* 'k_1 (square x)) (* 'k_2 (square y))))))

(test-case "components with conditions of their own, and all of them together"
  (define v (verify-solution L-apart (lambda (t) (* (cos (* 'w t)) (up 'a 'b)))))
  (check-equal? (alternatives v)
                '(((= k_1 (* m_1 (expt w 2))) (= k_2 (* m_2 (expt w 2))))))
  (check-true (string-contains? (format "~a" v) "\n  all zero if: k_1 = (* m_1 (expt w 2)), ")))

(test-case "conditions of components that cannot hold together are not told of all"
  (define v (prove-zero (up (* (- 'a 1) 'b) (* (- 'a 2) 'b))))
  (check-equal? (alternatives v) '()))

(test-case "a condition that follows from those of other components is not told again"
  (define v (prove-zero (up (- 'a 'b) (- 'b 'c) (- 'a 'c))))
  (check-equal? (length (car (alternatives v))) 2))

(test-case "of a residual alone nobody knows which symbols may be zero, but every factor is told"
  (check-equal? (alternatives (prove-zero (* 'c (- 'k 'm)))) '(((= k m))))
  (check-equal? (alternatives (prove-zero (* 'c (- 'k 'm) (- 'a 'b)))) '(((= k m)) ((= a b)))))

(test-case "a coordinate that would be ignorable"
  (define (L (up t (up x y) (up vx vy))) (- (* 1/2 'm (+ (square vx) (square vy))) (* 'm 'g y)))
  (check-equal? (alternatives (verify-ignorable L 'y plane)) '(((= g 0)))))
