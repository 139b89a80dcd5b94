#lang mechanics
;; Exercise 1.18 (SICM 1.6.2): a bead on an ellipsoid
;; Checked: the Lagrangian in two angles
;; How: that the bead stays on the surface, and against the free particle's Lagrangian

;; A bead of mass m slides freely on the ellipsoid x²/a² + y²/b² + z²/c² = 1.  Choose
;; coordinates and find its Lagrangian.

(define ((on-the-surface a b c) (up t (up theta phi) v))
  (up (* a (sin theta) (cos phi))
      (* b (sin theta) (sin phi))
      (* c (cos theta))))

(define ((surface a b c) (up x y z))
  (- (+ (square (/ x a)) (square (/ y b)) (square (/ z c))) 1))

(define local (up 't (up 'theta 'phi) (up 'alpha 'beta)))
(define stays
  (prove-zero ((compose (surface 'a 'b 'c) (on-the-surface 'a 'b 'c)) local)))
stays

(define ((L-free m) (up t q v)) (* 1/2 m (square v)))
(define L (compose (L-free 'm) (F->C (on-the-surface 'a 'b 'c))))

(define ((attempt m a b c) (up t (up theta phi) (up alpha beta)))
  (* 1/2 m
     (+ (square (* a (- (* alpha (cos theta) (cos phi)) (* beta (sin theta) (sin phi)))))
        (square (* b (+ (* alpha (cos theta) (sin phi)) (* beta (sin theta) (cos phi)))))
        (square (* c alpha (sin theta))))))

;; One that believes the lines of constant θ and of constant φ to meet at right angles.
(define ((slip m a b c) (up t (up theta phi) (up alpha beta)))
  (* 1/2 m
     (+ (* (square (* alpha (cos theta)))
           (+ (square (* a (cos phi))) (square (* b (sin phi)))))
        (* (square (* beta (sin theta)))
           (+ (square (* a (sin phi))) (square (* b (cos phi)))))
        (square (* c alpha (sin theta))))))

(define right (verify-equal (L local) ((attempt 'm 'a 'b 'c) local)))
(define wrong (verify-equal (L local) ((slip 'm 'a 'b 'c) local)))
right
wrong

;; The rest is a product of both rates; for a surface of revolution it vanishes.
(prove-zero (substitute (verdict-residual wrong) 'b 'a))

(module+ test
  (require rackunit)
  (test-case "the coordinates are on the surface and give the Lagrangian"
    (check-pred proved? stays)
    (check-pred proved? right))
  (test-case "the lines meet at right angles where a = b only"
    (check-pred refuted? wrong)
    (check-pred proved? (prove-zero (substitute (verdict-residual wrong) 'b 'a)))))
