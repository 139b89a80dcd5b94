#lang mechanics
;; Exercise 4.2 (SICM 4.2.2): elliptical oscillation about a fixed point
;; Checked: that displacements by multipliers exp(±iB) go round an ellipse
;; How: the quadratic form that the matrix of the map keeps, for any such matrix

;; Solutions (4.26, 4.27) with A = 0: ξ = (u cos Bn − v sin Bn) a + (u sin Bn + v cos Bn) b, with
;; u + iv the eigenvector: combinations of cos Bn and sin Bn.
(define (xi u v a b)
  (lambda (n)
    (define-values (c s) (values (cos (* 'B n)) (sin (* 'B n))))
    (+ (* a (- (* u c) (* v s))) (* b (+ (* u s) (* v c))))))
(define one (xi 'u_0 'v_0 'a 'b))
(define other (xi 'u_1 'v_1 'a 'b))

;; An attempt: solve both for cos and sin; their squares add to 1.  With the determinant
;; w = u₀ v₁ − u₁ v₀, (v₁ ξ₀ − v₀ ξ₁)² + (u₁ ξ₀ − u₀ ξ₁)² = w² (a² + b²), a positive quadratic form.
(define (form x y)
  (+ (square (- (* 'v_1 x) (* 'v_0 y))) (square (- (* 'u_1 x) (* 'u_0 y)))))
(define w (- (* 'u_0 'v_1) (* 'u_1 'v_0)))
(define size (* (square w) (+ (square 'a) (square 'b))))
(define attempt (verify-equal (form (one 'n) (other 'n)) size))
attempt

;; A slip: a circle.  That holds only where u and v are as long as each other and perpendicular.
(define slip
  (verify-equal (+ (square (one 'n)) (square (other 'n)))
                (+ (square (one 0)) (square (other 0)))))

;; In numbers, the standard map at (π, 0), K = 0.6: M = (1 − K, 1; −K, 1) keeps
;; K ξ₀² + ξ₁² − K ξ₀ ξ₁, an ellipse.
(define K 0.6)
(define (M x y) (values (+ (* (- 1 K) x) y) (+ (* -1 K x) y)))
(define (kept x y) (+ (* K (square x)) (square y) (* -1 K x y)))
(define-values (x5 y5)
  (for/fold ([x 0.3] [y 0.1]) ([k 5]) (M x y)))
(list (kept 0.3 0.1) (kept x5 y5))

(module+ test
  (require rackunit)
  (test-case "an ellipse, and no circle"
    (check-pred proved? attempt)
    (check-pred refuted? slip))
  (test-case "of the standard map"
    (check-= (kept x5 y5) (kept 0.3 0.1) 1e-14)))
