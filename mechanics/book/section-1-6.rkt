#lang racket/base
;; SICM 1.6, How to Find Lagrangians (pp. 37–68), in the reader's own language.
;;
;; One way is T − V in rectangular coordinates, pulled back to coordinates that know of
;; the constraints; another is the energies in those coordinates, written at once.

(require mechanics
         (only-in "section-1-4.rkt" L-free-particle))

(provide L-uniform-acceleration L-central-rectangular
         L-free-rectangular L-free-polar L-rotating-polar L-rotating-rectangular rotating-polar
         T-pend V-pend L-pend dp-coordinates L-pendulum
         F-sliding-pend L-sliding-pend
         L-two-particle L-coupled-harmonic)

;; ---------------------------------------------------------------------------
;; One particle in rectangular coordinates

;; In the plane, falling in the direction of −y (p. 40).
(define ((L-uniform-acceleration m g) (up t (up x y) v))
  (- (* 1/2 m (square v))
     (* m g y)))

;; In the plane or in space, with the potential energy U(r) (p. 41).
(define ((L-central-rectangular m U) (up t q v))
  (- (* 1/2 m (square v))
     (U (sqrt (square q)))))

;; ---------------------------------------------------------------------------
;; A free particle in coordinates that turn at the rate Omega (p. 48)

(define (L-free-rectangular m) (L-free-particle m))

(define (L-free-polar m)
  (compose (L-free-rectangular m) (F->C p->r)))

;; Also (5.280): from polar coordinates that turn to those at rest.
(define ((rotating-polar Omega) (up t (up r theta) v))
  (up r (+ theta (* Omega t))))

(define (L-rotating-polar m Omega)
  (compose (L-free-polar m) (F->C (rotating-polar Omega))))

(define (L-rotating-rectangular m Omega)
  (compose (L-rotating-polar m Omega) (F->C r->p)))

;; ---------------------------------------------------------------------------
;; A pendulum of length l whose pivot is at the height ys(t); θ from the bottom

(define ((T-pend m l g ys) (up t theta thetadot)) ; p. 52
  (define vys (D ys))
  (* 1/2 m (+ (square (* l thetadot))
              (square (vys t))
              (* 2 l (vys t) thetadot (sin theta)))))

(define ((V-pend m l g ys) (up t theta thetadot))
  (* m g (- (ys t) (* l (cos theta)))))

(define L-pend (- T-pend V-pend))

;; The bob's rectangular coordinates, for L-uniform-acceleration (p. 61).
(define ((dp-coordinates l y_s) (up t theta thetadot))
  (up (* l (sin theta))
      (- (y_s t) (* l (cos theta)))))

;; With the pivot at rest at the height 0.
(define ((L-pendulum g m l) (up t theta thetadot))
  (+ (* 1/2 m (square (* l thetadot)))
     (* m g l (cos theta))))

;; ---------------------------------------------------------------------------
;; A pendulum of mass m2 and length l that hangs from a mass m1 sliding along x

;; The positions of both masses.
(define ((F-sliding-pend l) (up t (up x theta) v))
  (up (up x 0)
      (up (+ x (* l (sin theta)))
          (* -1 l (cos theta)))))

(define ((L-two-falling m1 m2 g) (up t (up (up x1 y1) (up x2 y2)) (up v1 v2)))
  (- (+ (* 1/2 m1 (square v1)) (* 1/2 m2 (square v2)))
     (+ (* m1 g y1) (* m2 g y2))))

(define (L-sliding-pend m1 m2 l g)
  (compose (L-two-falling m1 m2 g) (F->C (F-sliding-pend l))))

;; ---------------------------------------------------------------------------
;; Several particles

;; Two particles with the potential energy V, a function of both positions.
(define ((L-two-particle m1 m2 V) (up t (up x1 x2) (up v1 v2)))
  (- (+ (* 1/2 m1 (square v1)) (* 1/2 m2 (square v2)))
     (V x1 x2)))

;; Oscillators with masses and stiffnesses that are down tuples of down tuples.
(define ((L-coupled-harmonic m k) (up t q v))
  (- (* 1/2 v m v)
     (* 1/2 q k q)))
