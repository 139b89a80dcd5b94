#lang mechanics
;; Exercise 2.14 (SICM 2.10): the kinetic energy of the top
;; Checked: the energy about the pivot and about the centre of mass
;; How: against each other, with Steiner's theorem

;; The energy of a top is that of a rotation about the point where it stands.  Show that this is
;; the rotation about its centre of mass, together with the motion of the latter.

(define state (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))

;; The centre of mass is at the distance R along the axis of symmetry.
(define (center local) (* (Euler->M (coordinate local)) (up 0 0 'R)))
(define (energy-of-center local)
  (* 1/2 'M (square (velocity ((F->C center) local)))))

;; About the centre of mass, A_c and C; about the pivot, A_c + M R² and C.
(define by-parts (+ (T-body-Euler 'A_c 'A_c 'C) energy-of-center))
(define (about-pivot A) (T-body-Euler A A 'C))

(define attempt (about-pivot (+ 'A_c (* 'M (square 'R)))))
(define right (verify-equal (by-parts state) (attempt state)))
right

;; A slip: all three moments moved, as if the axis went past the pivot.
(define moved (+ 'C (* 'M (square 'R))))
(define slip (T-body-Euler (+ 'A_c (* 'M (square 'R))) (+ 'A_c (* 'M (square 'R))) moved))
(define wrong (verify-equal (by-parts state) (slip state)))
wrong

;; The energy in Euler angles that the section uses.
(define (as-in-the-book A C)
  (+ (* 1/2 A (+ (square 'thetadot) (square (* 'phidot (sin 'theta)))))
     (* 1/2 C (square (+ 'psidot (* 'phidot (cos 'theta)))))))
(define in-angles (verify-equal ((T-body-Euler 'A 'A 'C) state) (as-in-the-book 'A 'C)))
in-angles

(module+ test
  (require rackunit)
  (test-case "one energy, seen from two points"
    (check-pred proved? right)
    (check-pred proved? in-angles))
  (test-case "the slip is wrong by the spin of the whole mass at the distance R"
    (check-pred refuted? wrong)
    (check-pred proved?
                (verify-equal (verdict-residual wrong)
                              (* -1/2 'M (square 'R)
                                 (square (ref (Euler-state->omega-body state) 2)))))))
