#lang mechanics
;; Exercise 1.37 (SICM 1.9): velocities transformed
;; Checked: the rectangular velocity in polar coordinates, and a program that finds it
;; How: against F->C, for the polar coordinates and for arbitrary ones

;; Write a program that transforms velocities, given the transformation of coordinates,
;; with the help of Gamma-bar; and find the velocity (vx, vy) in polar coordinates.

(define (velocities-by F)
  (Gamma-bar (lambda (q) (D (compose F (Gamma q))))))

(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))
((velocities-by p->r) polar)

(define attempt
  (up (- (* 'rdot (cos 'phi)) (* 'r 'phidot (sin 'phi)))
      (+ (* 'rdot (sin 'phi)) (* 'r 'phidot (cos 'phi)))))
(define right (verify-equal ((velocities-by p->r) polar) attempt))
right

;; A slip: the units of what is left over show that a length is missing.
(define slip
  (up (- (* 'rdot (cos 'phi)) (* 'phidot (sin 'phi)))
      (+ (* 'rdot (sin 'phi)) (* 'phidot (cos 'phi)))))
(define wrong (verify-equal ((velocities-by p->r) polar) slip))
wrong

;; The program is right for any coordinates, also such as move.
(define x (literal-function 'x (-> (UP Real (UP Real Real)) Real)))
(define y (literal-function 'y (-> (UP Real (UP Real Real)) Real)))
(define (F local)
  (define place (up (time local) (coordinate local)))
  (up (x place) (y place)))
(define any (verify-equal ((velocities-by F) polar) (velocity ((F->C F) polar))))
any

(module+ test
  (require rackunit)
  (test-case "velocities in polar coordinates, and in any"
    (check-pred proved? right)
    (check-pred proved? any))
  (test-case "the slip is right at the distance 1"
    (check-pred refuted? wrong)
    (check-equal? (map expression (verdict-conditions wrong)) '((= r 1)))))
