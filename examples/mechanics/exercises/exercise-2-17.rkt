#lang mechanics
;; Exercise 2.17 (SICM 2.11.1): the potential energy of a body in the field of a point
;; Checked: three sums over a body in terms of its moments, and the potential made of them
;; How: for point masses; with the tensor of the library; by a series in 1/R

;; A body with its centre of mass at the origin, a mass M' at the distance R in the direction n.
;; Express Σ m ξ cos θ, Σ m ξ² and Σ m ξ² sin² θ, θ being the angle between ξ and n.

;; Three points, the third where the centre of mass wants it.
(define masses '(m_1 m_2 m_3))
(define-values (xi-1 xi-2) (values (up 'x_1 'y_1 'z_1) (up 'x_2 'y_2 'z_2)))
(define points
  (list xi-1 xi-2 (/ (+ (* 'm_1 xi-1) (* 'm_2 xi-2)) (* -1 'm_3))))
(define n (up (* (sin 'alpha) (cos 'beta)) (* (sin 'alpha) (sin 'beta)) (cos 'alpha)))
(define (sum-over f) (apply + (map (lambda (m xi) (* m (f xi))) masses points)))
(define (along xi) (dot-product n xi))

(define tensor (inertia-tensor masses points))
(define first (prove-zero (sum-over along)))
(define second (verify-equal (* 2 (sum-over square)) (trace tensor)))
(define third (verify-equal (sum-over (lambda (xi) (- (square xi) (square (along xi)))))
                            (dot-product n (* tensor n))))
(map verdict-status (list first second third))

;; b. With principal axes, I = Σ cos² of the angles to the axes times A, B and C.
(define principal (matrix-by-rows '(A 0 0) '(0 B 0) '(0 0 C)))
(define by-angles
  (verify-equal (dot-product n (* principal n))
                (+ (* (square (ref n 0)) 'A) (* (square (ref n 1)) 'B) (* (square (ref n 2)) 'C))))
by-angles

;; So V = −G M M'/R − G M'/(2 R³) (A + B + C − 3 I), but for terms of 1/R⁴: the distance of a
;; point is √(R² − 2 R n · ξ + ξ²).  With 1/R = s,
(define ((potential xi) s)
  (/ (* -1 s) (sqrt (+ 1 (* -2 s (along xi)) (* (square s) (square xi))))))
(define (coefficient k)
  (/ (sum-over (lambda (xi) (((expt D k) (potential xi)) 0))) (factorial k)))
(define I (dot-product n (* tensor n)))
(define right (verify-equal (coefficient 3) (* -1/2 (- (trace tensor) (* 3 I)))))
(define others (verify-equal (up (coefficient 1) (coefficient 2)) (up (- (apply + masses)) 0)))
right
others

;; A slip: the moment about the line counted once.
(define slip (verify-equal (coefficient 3) (* -1/2 (- (trace tensor) I))))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "the sums, and the potential to the third order"
    (for ([v (list first second third by-angles right others)]) (check-pred proved? v)))
  (test-case "the slip is off by the moment about the line"
    (check-pred refuted? slip)
    (check-pred proved? (verify-equal (verdict-residual slip) I))))
