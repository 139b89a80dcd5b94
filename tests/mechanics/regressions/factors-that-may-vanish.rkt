#lang racket/base
;; v²/2 and c v²/2 were equivalent whatever c: for c = 0 every path solves the second.

(require mechanics
         "../support/checks.rkt")

(define local (up 't 'x 'v))
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))
(define (L-free s) (* 1/2 (square (velocity s))))
(define ((scaled c L) s) (* c (L s)))
(define ((two-masses m1 m2) (up _ _ (up vx vy)))
  (* 1/2 (+ (* m1 (square vx)) (* m2 (square vy)))))

(define (conditions L1 L2 state)
  (define v (verify-equivalent-Lagrangians L1 L2 state))
  (check-pred proved? v)
  (verdict-assumptions v))

(test-case "a factor is not 0, nor is what divides it"
  (check-equal? (conditions L-free (scaled 'c L-free) local) '((> (abs c) 0)))
  (check-equal? (conditions L-free (scaled (- 'a 'b) L-free) local) '((> (abs (- a b)) 0)))
  (check-equal? (conditions (scaled 'c L-free) L-free local) '((> (abs c) 0)))
  (check-equal? (conditions L-free (scaled 2 L-free) local) '())
  (define size (sqrt (square 'm)))      ; m, where it is taken for positive
  (check-equal? (conditions L-free (scaled size L-free) local) '((> m 0))))

(test-case "a matrix of factors has an inverse"
  (check-equal? (conditions (two-masses 1 1) (two-masses 'c 1) plane) '((> (abs c) 0)))
  (check-equal? (conditions (two-masses 1 1) (two-masses 2 3) plane) '()))

(test-case "a factor declared not to be 0 is no condition"
  (check-equal? (assuming ('(> c 0)) (conditions L-free (scaled 'c L-free) local)) '()))

;; With d = |a − b| both have the same motions where d = 1: such a place is no witness.
(test-case "a witness takes no sign for granted in silence"
  (define d (sqrt (square (- 'a 'b))))
  (define ((oscillators m k) (up _ (up x y) (up vx vy)))
    (- (+ (square vx) (* m (square vy))) (+ (square x) (* k (square y)))))
  (define v (verify-equivalent-Lagrangians (oscillators d d) (oscillators d 1) plane))
  (check-pred refuted? v)
  (define (at name) (cdr (assoc name (verdict-witness v))))
  (check-not-equal? (abs (- (at 'a) (at 'b))) 1))
