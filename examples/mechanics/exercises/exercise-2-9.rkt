#lang mechanics
;; Exercise 2.9 (SICM 2.7): angular velocity in Euler angles
;; Checked: ω in space, and ω and the energy for angles of another kind
;; How: against the matrices of the rotations

;; The book has ω on the body.  Find it in space; and find it for a body that is turned otherwise,
;; as one says of ships: by c about x, then by b about y, then by a about z.

(define state (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))

(define attempt
  (up (+ (* 'thetadot (cos 'phi)) (* 'psidot (sin 'theta) (sin 'phi)))
      (- (* 'thetadot (sin 'phi)) (* 'psidot (sin 'theta) (cos 'phi)))
      (+ 'phidot (* 'psidot (cos 'theta)))))
(define right (verify-equal ((M->omega Euler->M) state) (up->column-matrix attempt)))
right

;; A slip: ω on the body with φ and ψ exchanged, which is nearly it.
(define slip
  (up (+ (* 'psidot (sin 'theta) (sin 'phi)) (* 'thetadot (cos 'phi)))
      (- (* 'psidot (sin 'theta) (cos 'phi)) (* 'thetadot (sin 'phi)))
      (+ 'phidot (* 'psidot (cos 'theta)))))
(define wrong (verify-equal ((M->omega Euler->M) state) (up->column-matrix slip)))
(verdict-status wrong)
(matrix-ref (verdict-residual wrong) 1 0)

;; A ship: heading, pitch and roll.
(define (ship (up a b c)) (* (Rz-matrix a) (Ry-matrix b) (Rx-matrix c)))
(define local (up 't (up 'a 'b 'c) (up 'adot 'bdot 'cdot)))
(define on-board
  (up (- 'cdot (* 'adot (sin 'b)))
      (+ (* 'bdot (cos 'c)) (* 'adot (cos 'b) (sin 'c)))
      (- (* 'adot (cos 'b) (cos 'c)) (* 'bdot (sin 'c)))))
(define rolling (verify-equal ((M->omega-body ship) local) (up->column-matrix on-board)))
rolling

;; These angles fail where the bow points up.
(define T (compose (T-body 'A 'B 'C) (M->omega-body ship)))
(determinant (((square (partial 2)) T) local))

(module+ test
  (require rackunit)
  (test-case "in space, and for a ship"
    (check-pred proved? right)
    (check-pred proved? rolling))
  (test-case "the second component has another sign than on the body"
    (check-pred refuted? wrong)
    (check-pred proved? (verify-equal (matrix-ref (verdict-residual wrong) 1 0)
                                      (* 2 (ref attempt 1)))))
  (test-case "the masses of a ship"
    (check-pred proved? (verify-equal (determinant (((square (partial 2)) T) local))
                                      (* 'A 'B 'C (square (cos 'b)))))))
