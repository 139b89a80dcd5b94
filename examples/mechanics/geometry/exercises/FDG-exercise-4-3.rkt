#lang mechanics
;; Exercise 4.3 (FDG 4): rotations of space and rotations of rotations
;; Checked: the fields of turning in space commute as those on the group of rotations do
;; How: all three commutators of each

(require mechanics/geometry)

;; Points of space turn about the axes,
(define-coordinates (up x y z) R3-rect)
(define turning-space
  (list (- (* y d/dz) (* z d/dy)) (- (* z d/dx) (* x d/dz)) (- (* x d/dy) (* y d/dx))))

;; and so do the positions of a body, told by Euler's angles.
(define-coordinates (up theta phi psi) Euler-angles)
(define turning-body
  (list (+ (* (cos phi) d/dtheta) (* -1 (/ (* (sin phi) (cos theta)) (sin theta)) d/dphi)
           (* (/ (sin phi) (sin theta)) d/dpsi))
        (+ (* (sin phi) d/dtheta) (* (/ (* (cos phi) (cos theta)) (sin theta)) d/dphi)
           (* -1 (/ (cos phi) (sin theta)) d/dpsi))
        d/dphi))

;; [J_x, J_y] = s J_z, and the other two
(define (commute fields s)
  (for/list ([i '(0 1 2)] [j '(1 2 0)] [k '(2 0 1)])
    (verify-equal (commutator (list-ref fields i) (list-ref fields j))
                  (* s (list-ref fields k)))))
(define of-space (commute turning-space -1))
(define of-the-body (commute turning-body -1))
of-space
of-the-body

;; The slip: the sign that the vector product has
(define wrong (commute turning-space 1))
(map verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "they commute alike"
    (for ([verdict (append of-space of-the-body)]) (check-pred proved? verdict))
    (for ([verdict wrong]) (check-pred refuted? verdict))))
