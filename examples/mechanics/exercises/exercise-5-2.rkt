#lang mechanics
;; Exercise 5.2 (SICM 5.1): rotations of coordinates and momenta
;; Checked: that momenta turn as coordinates do
;; How: the extended transformation against the same rotation of both

;; Extend a rotation about the z axis by a fixed angle to phase space.

(define (turned state) ((Rz 'theta) (coordinate state)))
(define state (up 't (up 'x 'y 'z) (down 'p_x 'p_y 'p_z)))

(define (both angle)
  (lambda (state)
    (up (time state)
        ((Rz angle) (coordinate state))
        (flip ((Rz angle) (flip (momentum state)))))))

(define right (verify-equal ((F->CH turned) state) ((both 'theta) state)))
right
(define canonical (verify-canonical (both 'theta) state))
canonical

;; The slip: momenta the other way, as "covectors transform by the inverse".
(define (slip-transformation state)
  (up (time state)
      ((Rz 'theta) (coordinate state))
      (flip ((Rz (- 'theta)) (flip (momentum state))))))
(define slip (verify-canonical slip-transformation state))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "both turn alike"
    (check-pred proved? right)
    (check-pred proved? canonical))
  (test-case "the transposed inverse of a rotation is the rotation"
    (check-pred refuted? slip)))
