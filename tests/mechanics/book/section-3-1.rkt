#lang racket/base
;; SICM 3.1, Hamilton's Equations (pp. 195-217).

(require mechanics
         mechanics/scmutils
         mechanics/book
         "../support/checks.rkt" "../support/session.rkt")

(define V (literal-function 'V (-> (X Real Real) Real)))
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))
(define phase (up 't (up 'x 'y) (down 'p_x 'p_y)))
(define q (up (literal-function 'x) (literal-function 'y)))
(define p (down (literal-function 'p_x) (literal-function 'p_y)))

(define H-book
  '(+ (V x y) (/ (* 1/2 (expt p_x 2)) m) (/ (* 1/2 (expt p_y 2)) m)))

(test-case "p. 204: Hamilton's equations of a particle in the plane"
  (check-prints ((H-rectangular 'm V) phase) H-book)
  (check-prints (((Hamilton-equations (H-rectangular 'm V)) q p) 't)
                '(up 0
                     (up (- ((D x) t) (/ (p_x t) m))
                         (- ((D y) t) (/ (p_y t) m)))
                     (down (+ ((D p_x) t) (((partial 0) V) (x t) (y t)))
                           (+ ((D p_y) t) (((partial 1) V) (x t) (y t)))))))

(test-case "p. 204: the state derivative, by both its names"
  (for ([f (list Hamiltonian->state-derivative phase-space-derivative)])
    (check-prints ((f (H-rectangular 'm V)) phase)
                  '(up 1
                       (up (/ p_x m) (/ p_y m))
                       (down (* -1 (((partial 0) V) x y)) (* -1 (((partial 1) V) x y)))))))

(test-case "p. 204: paths of states"
  (check-unsimplified ((qp->H-state-path q p) 't)
                      '(up t (up (x t) (y t)) (down (p_x t) (p_y t)))))

(test-case "the Hamiltonian is conserved unless it depends on the time"
  (define H (literal-function 'H (Hamiltonian 2)))
  (check-identity (* ((D H) phase) ((Hamiltonian->state-derivative H) phase))
                  (((partial 0) H) phase)))

;; ---------------------------------------------------------------------------
;; 3.1.1 The Legendre transformation

(test-case "p. 213: from the Lagrangian to the Hamiltonian, and back"
  (define H (Lagrangian->Hamiltonian (L-rectangular 'm V)))
  (check-prints (H phase) H-book)
  (check-identity (H phase) ((H-rectangular 'm V) phase))
  (check-identity ((Hamiltonian->Lagrangian H) plane) ((L-rectangular 'm V) plane))
  (check-identity ((Hamiltonian->Lagrangian (H-rectangular 'm V)) plane)
                  ((L-rectangular 'm V) plane)))

(test-case "the transform of a quadratic form, and its own transform"
  (define (F v) (+ 'a (* 'b v) (* 1/2 'c (square v))))
  (define G (Legendre-transform F))
  (check-identity (G 'w) (- (/ (square (- 'w 'b)) (* 2 'c)) 'a))
  (check-identity ((Legendre-transform G) 'v) (F 'v)))

(test-case "passive variables: gradients by them are opposite"
  (define L (L-pend 'm 'l 'g (literal-function 'y_s)))
  (define H (Lagrangian->Hamiltonian L))
  (define local (up 't 'theta 'thetadot))
  (define state ((Lstate->Hstate L) local))
  (check-identity (((partial 0) H) state) (- (((partial 0) L) local)))
  (check-identity (((partial 1) H) state) (- (((partial 1) L) local)))
  (check-identity (((partial 2) H) state) 'thetadot))

(test-case "a central force in polar coordinates"
  (check-prints ((Lagrangian->Hamiltonian (L-central-polar 'm (literal-function 'U)))
                 (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
                '(+ (U r)
                    (/ (* 1/2 (expt p_r 2)) m)
                    (/ (* 1/2 (expt p_phi 2)) (* m (expt r 2))))))

(test-case "states from velocities to momenta and back"
  (define L (L-rectangular 'm V))
  (check-unsimplified (simplify ((Lstate->Hstate L) plane))
                      '(up t (up x y) (down (* m vx) (* m vy))))
  (check-unsimplified (simplify ((Hstate->Lstate (Lagrangian->Hamiltonian L))
                                 ((Lstate->Hstate L) plane)))
                      '(up t (up x y) (up vx vy))))

(test-case "p. 213: what the transform of the book is made of"
  (check-equal? (compatible-zero (down 'p_x 'p_y)) (up 0 0))
  (check-equal? (dual-zero 'p) 0)
  (check-equal? (zero-like (down 'p_x 'p_y)) (down 0 0)))
