#lang racket/base
;; SICM 5.5, Extended Phase Space (pp. 394–402), in the reader's own language.

(require mechanics)

(provide H-restricted-three-body)

;; A body of mass m in the field of two, a distance a apart, that circle about their centre of mass
;; at the rate Ω = √(G (m₁ + m₂)/a³), in polar coordinates (5.278).
(define ((H-restricted-three-body m G m_1 m_2 a) (up t (up r theta) (down p_r p_theta)))
  (define Omega (sqrt (/ (* G (+ m_1 m_2)) (expt a 3))))
  (define-values (a_1 a_2) (values (/ (* m_2 a) (+ m_1 m_2)) (/ (* m_1 a) (+ m_1 m_2))))
  (define c (cos (- theta (* Omega t))))
  (define r_1 (sqrt (+ (square r) (square a_1) (* 2 a_1 r c))))
  (define r_2 (sqrt (+ (square r) (square a_2) (* -2 a_2 r c))))
  (- (/ (+ (square p_r) (square (/ p_theta r))) (* 2 m))
     (/ (* G m m_1) r_1)
     (/ (* G m m_2) r_2)))
