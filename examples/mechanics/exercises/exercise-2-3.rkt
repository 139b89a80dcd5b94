#lang mechanics
;; Exercise 2.3 (SICM 2.3): some useful moments of inertia
;; Checked: moments of a ball, a shell, a cylinder and a rod
;; How: against integrals over the density, and one from the other

;; Find the moments of inertia of a homogeneous ball, of a thin spherical shell, of a cylinder
;; about its axis, and of a thin rod about a line across its middle.

;; A ball is made of discs: one at the height z has the radius² R² − z².  The moment of a disc
;; about its axis is half its mass times its radius².
(define R 1.7)
(define (disc-mass z) (* :pi (- (square R) (square z))))
(define mass (definite-integral disc-mass (- R) R))
(define (moment weight)
  (/ (definite-integral (lambda (z) (* weight (disc-mass z) (- (square R) (square z)))) (- R) R)
     (* mass (square R))))
(moment 1/2)

(define (near? a b) (< (abs (- a b)) 1e-9))
(define (first-moment I) (ref (principal-moments I) 0))
(define (last-moment I) (matrix-ref I 2 2))

;; In units of M R², an attempt, and what the slip gives that takes a disc for a ring.
(near? (moment 1/2) 2/5)
(near? (moment 1) 2/5)

;; A shell is what a ball gains when it grows: the derivative of ρ 4/3 π R³ · 2/5 R², divided by
;; that of the mass.
(define (ball r) (* 'rho 4/3 'pi (cube r) 2/5 (square r)))
(define (ball-mass r) (* 'rho 4/3 'pi (cube r)))
(define shell (/ ((D ball) 'R) ((D ball-mass) 'R)))
(define right (verify-equal shell (* 2/3 (square 'R))))
right

;; The formulas of the library.
(list (first-moment (ball-inertia 'M 'R)) (first-moment (shell-inertia 'M 'R)))
(list (last-moment (cylinder-inertia 'M 'R 'h)) (first-moment (rod-inertia 'M 'l)))

;; A rod by its density, which is a box that is thin.
(define rod (density->body 1 '(-1 1) '(-1/1000 1/1000) '(-1/1000 1/1000)))
(define rod-in-units (/ (last-moment (body-inertia rod)) (* (body-mass rod) 4)))
(< (abs (- rod-in-units 1/12)) 1e-6)

(module+ test
  (require rackunit)
  (test-case "a ball has two fifths, a shell two thirds"
    (check-= (moment 1/2) 2/5 1e-9)
    (check-pred proved? right)
    (check-pred proved? (verify-equal (first-moment (ball-inertia 'M 'R)) (* 2/5 'M (square 'R)))))
  (test-case "rings have twice that of discs"
    (check-= (moment 1) 4/5 1e-9))
  (test-case "a thin rod has a twelfth, but for its thickness"
    (check-= rod-in-units 1/12 1e-6)))
