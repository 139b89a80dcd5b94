#lang mechanics
;; Exercise 2.9 (SICM 2.7): Euler angles of any rotation
;; Checked: three formulas for the angles of a rotation given by its matrix
;; How: put into the matrix of the angles; on rotations about axes; where they fail

;; Show that each rotation R has Euler angles: solve R = R_z(φ) R_x(θ) R_z(ψ) for them.

;; An attempt, from the last row and the last column of the matrix.
(define (entry R i j) (matrix-ref R i j))
(define (angles R)
  (up (acos (entry R 2 2))
      (atan (entry R 0 2) (* -1 (entry R 1 2)))
      (atan (entry R 2 0) (entry R 2 1))))

;; The last column is sin θ (sin φ, −cos φ, 0) and cos θ: of angles with sin θ > 0 come these.
(define M (Euler->M (up 'theta 'phi 'psi)))
(define column
  (verify-equal (up (entry M 0 2) (entry M 1 2) (entry M 2 0) (entry M 2 1) (entry M 2 2))
                (up (* (sin 'theta) (sin 'phi)) (* -1 (sin 'theta) (cos 'phi))
                    (* (sin 'theta) (sin 'psi)) (* (sin 'theta) (cos 'psi)) (cos 'theta))))
column

;; Rotations of all kinds, by axis and angle: are the matrices of these angles the same?
(define (off formula R)
  (define difference (- (Euler->M (formula R)) R))
  (apply max (for*/list ([i 3] [j 3]) (abs (entry difference i j)))))
(define some-rotations
  (for*/list ([angle '(0.5 2. 3. -1.)] [axis (list (up 1 2 3) (up -1 0.2 0) (up 0.1 -2 -1))])
    (angle-axis->rotation-matrix angle (/ axis (sqrt (square axis))))))
(define worst (apply max (map (lambda (R) (off angles R)) some-rotations)))
(< worst 1e-14)

;; A slip: the sign of the second argument, as on the body.
(define (slip R) (up (ref (angles R) 0) (atan (entry R 0 2) (entry R 1 2)) (ref (angles R) 2)))
(define worst-slip (apply max (map (lambda (R) (off slip R)) some-rotations)))
(> worst-slip 1)

;; Where θ = 0 the column says nothing of φ, and φ + ψ is all that there is.
(define turns (verify-equal (Euler->M (up 0 'phi 'psi)) (Rz-matrix (+ 'phi 'psi))))
turns
(define (upright R) (up 0 0 (atan (entry R 1 0) (entry R 0 0))))
(off upright (Rz-matrix 0.7))

(module+ test
  (require rackunit)
  (test-case "the entries that are used, and where the angles are one"
    (check-pred proved? column)
    (check-pred proved? turns))
  (test-case "the formulas are right for rotations of all kinds"
    (check-= worst 0 1e-14)
    (check-true (> worst-slip 1)))
  (test-case "a rotation about z needs a formula of its own; the library names what fails"
    (check-exn #rx"the point at the origin has no angle" (lambda () (angles (Rz-matrix 0.7))))
    (check-= (off upright (Rz-matrix 0.7)) 0 1e-15)
    (check-exn #rx"Euler angles are singular" (lambda () (M->Euler (Rz-matrix 0.7))))
    (for ([R some-rotations]) (check-= (off M->Euler R) 0 1e-14))))
