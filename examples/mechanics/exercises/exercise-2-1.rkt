#lang mechanics
;; Exercise 2.1 (SICM 2.3): rotational kinetic energy
;; Checked: that it is ½ I ω², with the moment I about the line of ω
;; How: against the sum of ½ m v² over points, and against the inertia tensor

;; A body turns at the rate w about a line through its centre of mass, with the direction n of
;; unit length.  Is its energy half its moment of inertia about that line times w²?

(define n (up (* (sin 'alpha) (cos 'beta)) (* (sin 'alpha) (sin 'beta)) (cos 'alpha)))
(define points (list (up 'x_1 'y_1 'z_1) (up 'x_2 'y_2 'z_2)))
(define (sum-over f) (apply + (map f '(m_1 m_2) points)))

(define T (sum-over (lambda (m xi) (* 1/2 m (square (cross-product (* 'w n) xi))))))

;; An attempt: the moment has the squares of the distances from the line.
(define (distance^2 xi) (- (square xi) (square (dot-product n xi))))
(define moment (sum-over (lambda (m xi) (* m (distance^2 xi)))))
(define right (verify-equal (* 1/2 moment (square 'w)) T))
right
(define by-tensor
  (verify-equal moment (dot-product n (* (inertia-tensor '(m_1 m_2) points) n))))
by-tensor

;; A slip: the distances from the centre of mass.
(define slip
  (verify-equal (* 1/2 (sum-over (lambda (m xi) (* m (square xi)))) (square 'w)) T))
(verdict-status slip)

;; Its surplus is the part along the line.
(define too-much
  (verify-equal (verdict-residual slip)
                (* 1/2 (square 'w) (sum-over (lambda (m xi) (* m (square (dot-product n xi))))))))
too-much

(module+ test
  (require rackunit)
  (test-case "the energy by the moment, and the moment by the tensor"
    (check-pred proved? right)
    (check-pred proved? by-tensor))
  (test-case "the distance is that from the line"
    (check-pred refuted? slip)
    (check-pred proved? too-much)))
