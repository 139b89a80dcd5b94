#lang racket/base
;; SICM 1.8, Conserved Quantities (pp. 78–91), in the reader's own language.

(require mechanics
         (only-in "section-1-6.rkt" L-central-rectangular))

(provide T3-spherical L3-central ang-mom-z
         L0 restricted-three-body-potential LR3B LR3B1
         F-tilde the-Noether-integral)

;; ---------------------------------------------------------------------------
;; Central forces in space, in spherical coordinates (p. 84)

(define ((T3-spherical m) (up t (up r theta phi) (up rdot thetadot phidot)))
  (* 1/2 m (+ (square rdot)
              (square (* r thetadot))
              (square (* r (sin theta) phidot)))))

(define (L3-central m Vr)
  (define (Vs local) (Vr (ref (coordinate local) 0)))
  (- (T3-spherical m) Vs))

;; The z component of the angular momentum, in rectangular coordinates (p. 85).
(define ((ang-mom-z m) (up t xyz v))
  (ref (cross-product xyz (* m v)) 2))

;; ---------------------------------------------------------------------------
;; The restricted three-body problem (pp. 86–88): two bodies of masses M0 and M1, at the
;; constant distance a, circle about their centre of mass; a third one of mass m moves in
;; their plane and does not disturb them.

;; A particle in a potential that depends on the time (p. 86).
(define ((L0 m V) (up t q v))
  (- (* 1/2 m (square v))
     (V t q)))

;; The rate at which the two circle, and their distances from the centre.
(define (circling a GM0 GM1)
  (define GM (+ GM0 GM1))
  (values (sqrt (/ GM (expt a 3)))
          (* (/ GM1 GM) a)
          (* (/ GM0 GM) a)))

;; The potential energy of the third body, for L0 (p. 87).
(define ((restricted-three-body-potential a GM0 GM1 m) t q)
  (define-values (Omega a0 a1) (circling a GM0 GM1))
  (define axis (up (cos (* Omega t)) (sin (* Omega t))))
  (define r0 (sqrt (square (+ q (* a0 axis)))))
  (define r1 (sqrt (square (- q (* a1 axis)))))
  (- (+ (/ (* GM0 m) r0)
        (/ (* GM1 m) r1))))

;; The Lagrangian on axes that turn with the two bodies (p. 88).
(define (LR3B m a GM0 GM1)
  (define-values (Omega a0 a1) (circling a GM0 GM1))
  (LR3B1 m a0 a1 Omega GM0 GM1))

;; The same with distances and rate as they are given.
(define ((LR3B1 m a0 a1 Omega GM0 GM1) (up t (up x y) (up xdot ydot)))
  (define r0 (sqrt (+ (square (+ x a0)) (square y))))
  (define r1 (sqrt (+ (square (- x a1)) (square y))))
  (+ (* 1/2 m (+ (square xdot) (square ydot)))
     (* 1/2 m (square Omega) (+ (square x) (square y)))
     (* m Omega (- (* x ydot) (* xdot y)))
     (/ (* GM0 m) r0)
     (/ (* GM1 m) r1)))

;; ---------------------------------------------------------------------------
;; Noether's theorem for rotations (p. 91)

(define (F-tilde angle-x angle-y angle-z)
  (compose (Rx angle-x) (Ry angle-y) (Rz angle-z) coordinate))

;; The angular momentum of a particle of mass m in a central potential U.
(define the-Noether-integral
  (Noether-integral (L-central-rectangular 'm (literal-function 'U)) F-tilde))
