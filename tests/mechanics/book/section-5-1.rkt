#lang racket/base
;; SICM 5.1, Point Transformations (pp. 336-341).

(require mechanics
         mechanics/book
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define polar (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
(define space (up 't (up 'x 'y 'z) (down 'p_x 'p_y 'p_z)))

(test-case "p. 339: a central field in polar coordinates"
  (check-prints ((compose (H-central 'm (literal-function 'V)) (F->CH p->r)) polar)
                '(+ (/ (* 1/2 (expt p_phi 2)) (* m (expt r 2)))
                    (/ (* 1/2 (expt p_r 2)) m)
                    (V r)))
  (check-identity ((compose (H-central 'm (literal-function 'V)) (F->CH p->r)) polar)
                  ((Lagrangian->Hamiltonian (L-central-polar 'm (literal-function 'V))) polar)))

(test-case "the momenta are those that the Lagrangians give"
  (define L (compose (L-central-rectangular 'm (literal-function 'V)) (F->C p->r)))
  (define local (up 't (up 'r 'phi) (up 'rdot 'phidot)))
  (check-identity ((F->CH p->r) ((Lstate->Hstate L) local))
                  ((compose (Lstate->Hstate (L-central-rectangular 'm (literal-function 'V)))
                            (F->C p->r))
                   local)))

(test-case "p. 340: coordinates that move"
  (define v (up 'v_x 'v_y 'v_z))
  (check-identity ((F->K (translating v)) space) (- (* (down 'p_x 'p_y 'p_z) v)))
  (check-prints ((F->K (translating v)) space)
                '(+ (* -1 p_x v_x) (* -1 p_y v_y) (* -1 p_z v_z)))
  (check-identity ((F->K (rotating 'n)) space) ((K-rotating 'n) space)))

(test-case "p. 341: the free particle seen from a moving train"
  (define v (up 'v^x 'v^y 'v^z))
  (define p (down 'p_x 'p_y 'p_z))
  (check-identity (H-prime space) (- (/ (square p) (* 2 'm)) (* p v)))
  (check-identity ((canonical? (F->CH (translating v)) (H-free 'm) H-prime) space) (* 0 space)))

(test-case "numbers"
  (define old ((F->CH p->r) (up 0 (up 2.0 0.5) (down 0.25 3.0))))
  (check-close old
               (list 0
                     (* 2 (cos 0.5)) (* 2 (sin 0.5))
                     (- (* 0.25 (cos 0.5)) (* 1.5 (sin 0.5)))
                     (+ (* 0.25 (sin 0.5)) (* 1.5 (cos 0.5))))
               1e-14))

(test-case "the first edition calls it F->CT"
  (check-identity ((F->CT p->r) polar) ((F->CH p->r) polar)))

(says
 [((F->CH coordinate) (up 't 'x 'y 'z))
  "F->CH: expected a Hamiltonian state (up t q p)\n  given: (up t x y z), an up tuple of 4"]
 [((F->CH p->r) (up 't (up 'r 'phi) (up 'p_r 'p_phi)))
  "F->CH: the third part of a Hamiltonian state is the momenta, dual to the coordinates\n"
  "  coordinates: (up r phi)\n  in their place: (up p_r p_phi)\n"
  "  momenta are written (down p_r p_phi); velocities belong to a Lagrangian"]
 [(F->CH 3)
  "F->CH: expected a coordinate transformation, a function of the state that gives the old "
  "coordinates; given the number 3"]
 [((F->CH (lambda (state) (ref (coordinate state) 0))) polar)
  "F->CH: <function> takes 2 new coordinates to 1 old ones\n  new: (up r phi)\n  old: r"]
 [((F->CH (lambda (state) (up (time state) (coordinate state) 0))) polar)
  "F->CH: <function> takes 2 new coordinates to 4 old ones\n  new: (up r phi)\n"
  "  old: (up t (up r phi) 0)\n"
  "  the value is to be the coordinates alone, without time and momenta"])

(test-case "coordinates that do not determine each other"
  (define (squeezed state) (up (ref (coordinate state) 0) (ref (coordinate state) 0)))
  (check-message
   (string-append
    "F->CH: the new coordinates do not determine the old ones: the derivatives of squeezed "
    "have no inverse\n  derivatives: (down (up 1 1) (up 0 0))")
   ((F->CH squeezed) polar)
   exn:fail:mechanics:singular:matrix?))
