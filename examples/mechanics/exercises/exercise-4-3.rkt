#lang mechanics
;; Exercise 4.3 (SICM 4.2.2): the standard map near its fixed points
;; Checked: multipliers and directions at (0, 0) and (π, 0), and the K for which each is stable
;; How: with symbols, from the map's derivative; numbers by find-fixed-point

(require mechanics/book)

;; The matrix of the derivatives, without the turns.
(define ((kicked K) p)
  (define I (+ (ref p 1) (* K (sin (ref p 0)))))
  (up (+ (ref p 0) I) I))
(define (J theta) ((D (kicked 'K)) (up theta 0)))
(simplify (J 0))
(simplify (J :pi))

;; M (1, d) = ρ (1, d).  At 0: trace 2 + K, determinant 1, so
;; ρ = 1 + K/2 ± √(K + K²/4), and d = ρ − 1 − K.  At π put −K for K.
(define ((multiplier sign) K) (+ 1 (/ K 2) (* sign (sqrt (+ K (/ (square K) 4))))))
(define (solves? theta K rho)
  (define M (J theta))
  (define d (- rho 1 K))
  (define image (+ (* (ref M 0) 1) (* (ref M 1) d)))
  (verify-equal image (up rho (* rho d))))
(define at-0 (solves? 0 'K ((multiplier 1) 'K)))
(define at-pi (solves? :pi (- 'K) ((multiplier -1) (- 'K))))
(list at-0 at-pi)

;; The slip: the other's multiplier.
(define slip (solves? 0 'K ((multiplier 1) (- 'K))))

;; Stable where the trace is between −2 and 2: at 0, 2 + K, for −4 < K < 0; at π, 2 − K, for
;; 0 < K < 4.
(define (kind K theta) (fixed-point-kind (find-fixed-point (standard-map K) (up theta 0))))
(define (kinds K) (list (kind K 0.) (kind K 3.1)))
(kinds -4.5)
(kinds -2.)
(kinds 2.)
(kinds 4.5)

(module+ test
  (require rackunit)
  (test-case "multipliers and directions"
    (check-pred proved? at-0)
    (check-pred proved? at-pi)
    (check-pred refuted? slip)
    (check-= ((multiplier 1) 1.4) 3.07477270848675 1e-13))
  (test-case "where each is stable"
    (for ([K '(-3.9 -2. -0.1)])
      (check-equal? (kind K 0.) 'elliptic)
      (check-equal? (kind K 3.1) 'hyperbolic))
    (for ([K '(0.1 2. 3.9)])
      (check-equal? (kind K 0.) 'hyperbolic)
      (check-equal? (kind K 3.1) 'elliptic))
    (check-equal? (kind -4.5 0.) 'reflection-hyperbolic)
    (check-equal? (kind 4.5 3.1) 'reflection-hyperbolic)))
