#lang racket/base
;; A condition cleared the denominator of what was asked about: with R = −r the path had no
;; value.

(require mechanics "../support/checks.rkt")

(define (alternatives v)
  (for/list ([way (verdict-alternatives v)]) (map expression way)))

(define ((L-rolling m R r g) (up t theta thetadot))
  (+ (* 3/4 m (square (+ R r)) (square thetadot)) (* m g (+ R r) theta)))

(test-case "a path over R + r"
  (define (path t) (/ (* 'c 'g t t) (+ 'R 'r)))
  (check-equal? (alternatives (verify-solution (L-rolling 'm 'R 'r 'g) path))
                '(((= c 1/3)))))

(test-case "a Lagrangian that vanishes with R + r"
  (check-equal? (alternatives (verify-solution (L-rolling 'm 'R 'r 'g)
                                               (lambda (t) (* 'c t t))))
                '(((= g (* 3 c (+ R r)))))))

(test-case "a residual that was written with the denominator"
  (check-equal? (alternatives (prove-zero (* (- 'k 'm) (- 'a 'b) (- 'a 'b) (/ 1 (- 'a 'b)))))
                '(((= k m)))))

(test-case "resonance is no condition for a forced vibration"
  (define ((L-driven m k F w) (up t x v))
    (+ (* 1/2 m (square v)) (* -1/2 k (square x)) (* F x (cos (* w t)))))
  (define (driven t)
    (* (- 'F (* 'm 'b)) (/ (cos (* 'w t)) (square (- 'k (* 'm (square 'w)))))))
  (define v (verify-solution (L-driven 'm 'k 0 'w) driven))
  (check-equal? (alternatives v) '()))
