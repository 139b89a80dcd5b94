#lang mechanics
;; The same motions in other coordinates (SICM exercises 1.14 and 1.15).
;;
;; Let F give the old coordinates for new ones.  The residual of L ∘ C along a path q of
;; new coordinates is that of L along F ∘ Γ[q], multiplied by ∂₁F: if one vanishes, and
;; the new coordinates are good ones, so does the other.

(define (compare L F q)
  (define new ((Lagrange-equations (compose L (F->C F))) q))
  (define old ((Lagrange-equations L) (compose F (Gamma q))))
  (define directions (compose ((partial 1) F) (Gamma q)))
  (verify-equal (new 't) (* (old 't) (directions 't))))

;; A central force, from rectangular to polar coordinates.
(define (L-central (up t q v))
  (- (* 1/2 'm (square v)) ((literal-function 'U) (sqrt (square q)))))
(define polar-path (up (literal-function 'r) (literal-function 'phi)))
(compare L-central p->r polar-path)

;; Any Lagrangian, and any two coordinates in place of two others.
(define L-any (literal-function 'L (Lagrangian 2)))
(define (F-any (up t (up a b) v))
  (up ((literal-function 'x (-> (X Real Real Real) Real)) t a b)
      ((literal-function 'y (-> (X Real Real Real) Real)) t a b)))
(define any-path (up (literal-function 'a) (literal-function 'b)))
(compare L-any F-any any-path)

;; An attempt that goes wrong: polar velocities in the place of rectangular ones.
(define (L-attempt (up t (up r phi) (up rdot phidot)))
  (- (* 1/2 'm (+ (square rdot) (square phidot))) ((literal-function 'U) r)))
(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(compare-Lagrangians (compose L-central (F->C p->r)) L-attempt polar)

(module+ test
  (require rackunit)
  (test-case "the residuals are related as they should"
    (check-pred proved? (compare L-central p->r polar-path))
    (check-pred proved? (compare L-any F-any any-path)))
  (test-case "the attempt is no Lagrangian of this motion"
    (check-false (equivalence-kind
                  (compare-Lagrangians (compose L-central (F->C p->r)) L-attempt polar)))))
