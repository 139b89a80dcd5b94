#lang mechanics
;; Black holes: that their metrics satisfy Einstein's equations is proved component by component.

(require mechanics/geometry)
(define-coordinates (up t r theta phi) spacetime-sphere)
(define basis (coordinate-system->basis spacetime-sphere))
(define event ((point spacetime-sphere) (up 't 'r 'theta 'phi)))

(define (curvature metric) (Ricci (covariant-derivative (metric->Cartan metric basis)) basis))

;; Schwarzschild's: at rest and round, with G = c = 1.  Empty space has no Ricci curvature.
(define (Schwarzschild power)
  (define A (- 1 (/ (* 2 'M) (expt r power))))
  (make-metric
   (lambda (u v)
     (+ (* -1 A (dt u) (dt v)) (* (/ 1 A) (dr u) (dr v))
        (* (square r) (+ (* (dtheta u) (dtheta v))
                         (* (square (sin theta)) (dphi u) (dphi v))))))))
(define at-rest (verify-equal (curvature (Schwarzschild 1)) 0))
at-rest

;; Were the potential M/r², it would not be empty.
(define not-empty (verify-equal (curvature (Schwarzschild 2)) 0))
(verdict-status not-empty)

;; Kerr's, which turns, and Newman's, which is charged as well, in the coordinates of Boyer and
;; Lindquist.
(define sine^2 (square (sin theta)))
(define Sigma (+ (square r) (* (square 'a) (square (cos theta)))))
(define along (- dt (* 'a sine^2 dphi)))
(define (Kerr-Newman charge power)
  (define Delta (+ (square r) (* -2 'M r) (square 'a) (square charge)))
  (define around (- (* (+ (square r) (expt 'a power)) dphi) (* 'a dt)))
  (make-metric
   (lambda (u v)
     (+ (* -1 (/ Delta Sigma) (along u) (along v))
        (* (/ sine^2 Sigma) (around u) (around v))
        (* (/ Sigma Delta) (dr u) (dr v))
        (* Sigma (dtheta u) (dtheta v))))))
(define turning (verify-equal (curvature (Kerr-Newman 0 2)) 0))
turning

;; With a³ in place of one a² there is no empty space around it.
(define wrong (verify-equal (curvature (Kerr-Newman 0 3)) 0))
(verdict-status wrong)

;; A charge has a field around it, dA of this potential, that satisfies Maxwell's equations.
(define charged (Kerr-Newman 'Q 2))
(define F (d (* -1 (/ (* 'Q r) Sigma) along)))
(define no-current (verify-equal (d ((Hodge-star charged basis) F)) 0))
no-current

;; Its energy, momentum and stress curve the space: 8πT is twice F·F less a quarter of its trace.
(define (stress F metric)
  (define up-again (raise metric basis))
  (define F*F
    (with-argument-types
     (lambda (u v) (contract (lambda (e w) (* (F u e) (F v (up-again w)))) basis))
     '(vector vector) spacetime-sphere))
  (- (* 2 F*F) (* 1/2 ((trace2down metric) F*F) metric)))
(define with-charge (verify-equal (Einstein-tensor charged basis) (stress F charged)))
with-charge

;; Far away the field is that of a charge, and of a magnet of the moment Qa.
((F d/dr d/dt) event)

(module+ test
  (require rackunit)
  (test-case "what is proved"
    (for ([v (list at-rest turning no-current with-charge)]) (check-pred proved? v)))
  (test-case "what is refuted"
    (for ([v (list not-empty wrong)]) (check-pred refuted? v)))
  (test-case "the charge without rotation has Coulomb's field"
    (check-pred proved? (verify-equal (substitute ((F d/dr d/dt) event) 'a 0)
                                      (/ 'Q (square 'r))))))
