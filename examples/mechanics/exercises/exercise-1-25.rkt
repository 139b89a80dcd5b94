#lang mechanics
;; Exercise 1.25 (SICM 1.6.3): the Lagrangian of Foucault's pendulum
;; Checked: the kinetic energy of the bob, to first order in the turning of the earth
;; How: against a free particle, seen from a laboratory that turns

;; A pendulum of length l hangs at the colatitude β of an earth that turns at the rate Ω.
;; Of its Lagrangian keep what is of first order in Ω.  As coordinates take the bob's
;; polar ones about the vertical: the angle θ from it, and φ, from the south to the east.

(define ((from-angles l) (up t (up theta phi) v))
  (up (* l (sin theta) (cos phi))
      (* l (sin theta) (sin phi))
      (* -1 l (cos theta))))

;; The laboratory, x to the south, y to the east, is tilted by β against axes that turn.
(define ((laboratory->space beta Omega) (up t q v))
  ((Rz (* Omega t)) ((Ry beta) q)))

(define ((L-free m) (up t q v)) (* 1/2 m (square v)))
(define (T Omega)
  (compose (L-free 'm)
           (F->C (laboratory->space 'beta Omega))
           (F->C (from-angles 'l))))

(define local (up 't (up 'theta 'phi) (up 'thetadot 'phidot)))
(define first-order ((D (lambda (Omega) ((T Omega) local))) 0))

;; The vertical part of the turning acts as if φ turned with it; the level part acts
;; on swings in the plane of its axis.
(define vertical
  (* 'm (square 'l) (square (sin 'theta)) 'phidot (cos 'beta)))
(define ((level m l beta) (up t (up theta phi) (up thetadot phidot)))
  (* -1 m (square l) (sin beta)
     (+ (* thetadot (sin phi))
        (* phidot (sin theta) (cos theta) (cos phi)))))

(define right (verify-equal first-order (+ vertical ((level 'm 'l 'beta) local))))
(define wrong (verify-equal first-order vertical))
right
wrong

;; The shorter attempt is good for small swings all the same: the equations that its
;; residual has are of second order in θ.
(define equations
  ((Euler-Lagrange-operator (level 'm 'l 'beta))
   (up 't (up 'theta 'phi) (up 'thetadot 'phidot) (up 'alpha 'gamma))))
equations

(module+ test
  (require rackunit)
  (test-case "the turning's first order"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-pred proved? (verify-equal (verdict-residual wrong) ((level 'm 'l 'beta) local))))
  (test-case "the equations of what is left over have the factor sin² θ"
    (check-pred proved?
                (verify-equal equations
                              (* -2 'm (square 'l) (sin 'beta) (square (sin 'theta)) (cos 'phi)
                                 (down 'phidot (* -1 'thetadot)))))))
