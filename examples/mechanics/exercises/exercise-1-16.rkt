#lang mechanics
;; Exercise 1.16 (SICM 1.6.1): a central force in space
;; Checked: the Lagrangian in spherical coordinates
;; How: against the one in rectangular coordinates, transformed

;; A particle in space has the potential energy U(r).  Its Lagrangian in rectangular
;; coordinates is plain; find it in spherical ones, with the colatitude θ.

(define ((L-rectangular m U) (up t q v))
  (- (* 1/2 m (square v)) (U (sqrt (square q)))))

(define ((attempt m U) (up t (up r theta phi) (up rdot thetadot phidot)))
  (- (* 1/2 m (+ (square rdot)
                 (square (* r thetadot))
                 (square (* r (sin theta) phidot))))
     (U r)))

;; One that takes θ for a latitude, measured from the equator.
(define ((slip m U) (up t (up r theta phi) (up rdot thetadot phidot)))
  (- (* 1/2 m (+ (square rdot)
                 (square (* r thetadot))
                 (square (* r (cos theta) phidot))))
     (U r)))

(define U (literal-function 'U))
(define spherical (up 't (up 'r 'theta 'phi) (up 'rdot 'thetadot 'phidot)))
(define transformed ((compose (L-rectangular 'm U) (F->C s->r)) spherical))
(define right (verify-equal transformed ((attempt 'm U) spherical)))
(define wrong (verify-equal transformed ((slip 'm U) spherical)))
right
wrong

;; Where both agree the sine and the cosine are the same: the difference is the one
;; of their squares.
(/ (verdict-residual wrong) (- (square (sin 'theta)) (square (cos 'theta))))

(module+ test
  (require rackunit)
  (test-case "the colatitude's sine goes with the longitude"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-equal? (map expression (verdict-conditions wrong)) '())))
