#lang mechanics
;; Exercise 4.1 (FDG 4): turning about the axes, in other angles
;; Checked: the three fields of turning in the angles of Rz(φ) Rx(θ) Ry(ψ)
;; How: on the entries of the matrix, against matrices turned; and Euler's angles by numbers

(require mechanics/geometry)
(define-coordinates (up theta phi psi) alternate-angles)

(define a_x (+ (* (cos phi) d/dtheta)
               (* (/ (* (sin phi) (sin theta)) (cos theta)) d/dphi)
               (* -1 (/ (sin phi) (cos theta)) d/dpsi)))
(define a_y (+ (* (sin phi) d/dtheta)
               (* -1 (/ (* (cos phi) (sin theta)) (cos theta)) d/dphi)
               (* (/ (cos phi) (cos theta)) d/dpsi)))
(define a_z d/dphi)

;; A field of turning about an axis is the rate of the turned matrix, entry by entry.
(define rotation ((point alternate-angles) (up 'theta 'phi 'psi)))
(define (M m)
  (define-values (theta phi psi) (apply values (structure->list ((chart alternate-angles) m))))
  (* (Rz-matrix phi) (Rx-matrix theta) (Ry-matrix psi)))
(define (on-matrix field)
  (for*/list ([i 3] [j 3]) ((field (lambda (m) (ref (M m) i j))) rotation)))
(define (turned turn)
  (for*/list ([i 3] [j 3]) ((D (lambda (angle) (ref (* (turn angle) (M rotation)) i j))) 0)))
(define (verify-turning field turn)
  (verify-equal (list->up (on-matrix field)) (list->up (turned turn))))

(define right
  (map verify-turning (list a_x a_y a_z) (list Rx-matrix Ry-matrix Rz-matrix)))
right

;; The slip: the sign that Euler's angles have
(define wrong (verify-turning (- (* 2 (cos phi) d/dtheta) a_x) Rx-matrix))
(verdict-status wrong)

;; They do not commute: turning about x and y makes turning about z.
(define brackets (verify-equal (commutator a_x a_y) (- a_z)))
brackets

(module+ test
  (require rackunit)
  (test-case "the fields of turning"
    (for ([verdict right]) (check-pred proved? verdict))
    (check-pred refuted? wrong)
    (check-pred proved? brackets))
  (test-case "as in Euler's angles"
    (define-coordinates (up Theta Phi Psi) Euler-angles)
    (define e_x (+ (* (cos Phi) d/dTheta)
                   (* -1 (/ (* (sin Phi) (cos Theta)) (sin Theta)) d/dPhi)
                   (* (/ (sin Phi) (sin Theta)) d/dPsi)))
    (define m ((point alternate-angles) (up 0.3 0.4 0.5)))
    (for ([f (list Theta Phi Psi)])
      (check-= ((a_x f) m) ((e_x f) m) 1e-12))))
