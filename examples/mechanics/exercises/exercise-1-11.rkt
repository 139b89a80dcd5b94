#lang mechanics
;; Exercise 1.11 (SICM 1.5): Kepler's third law
;; Checked: the relation of rate and radius of a circular orbit
;; How: the residual of the orbit, and the condition in its verdict

;; Two bodies attract each other as Newton says, and circle at the constant distance a.
;; How does the rate n of the revolution depend on a?  The Lagrangian of their relative
;; motion has the reduced mass m and the sum M of both masses.

(define ((L-relative m G M) (up t (up r phi) (up rdot phidot)))
  (+ (* 1/2 m (+ (square rdot) (square (* r phidot))))
     (/ (* G M m) r)))

(define ((circle a n) t) (up a (* n t)))
(define L (L-relative 'm 'G 'M))

;; The verdict on a circle of any rate states the law.
(define any (verify-solution L (circle 'a 'n)))
any

;; An attempt with it put in; and one where the body of mass m_1 stays at its place and
;; that of the mass m_2 = M − m_1 circles it.
(define right (verify-solution L (circle 'a (sqrt (/ (* 'G 'M) (cube 'a))))))
(define wrong (verify-solution L (circle 'a (sqrt (/ (* 'G (- 'M 'm_2)) (cube 'a))))))
right
wrong

(module+ test
  (require rackunit)
  (test-case "n² a³ = G M"
    (check-equal? (map expression (verdict-conditions any))
                  '((= (* G M) (* (expt a 3) (expt n 2)))))
    (check-pred proved? right))
  (test-case "the fixed sun is refuted, unless the planet has no mass"
    (check-pred refuted? wrong)
    (check-pred proved? (prove-zero (substitute (verdict-residual wrong) 'm_2 0)))))
