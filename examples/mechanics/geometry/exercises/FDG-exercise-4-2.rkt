#lang mechanics
;; Exercise 4.2 (FDG 4): commutators on a basis that does not commute
;; Checked: the components of [u, v], with the structure constants of the basis
;; How: for fields with unknown components on the basis of rotations about three axes

(require mechanics/geometry)
(define-coordinates (up theta phi psi) Euler-angles)

(define e_x (+ (* (cos phi) d/dtheta) (* -1 (/ (* (sin phi) (cos theta)) (sin theta)) d/dphi)
               (* (/ (sin phi) (sin theta)) d/dpsi)))
(define e_y (+ (* (sin phi) d/dtheta) (* (/ (* (cos phi) (cos theta)) (sin theta)) d/dphi)
               (* -1 (/ (cos phi) (sin theta)) d/dpsi)))
(define e (list e_x e_y d/dphi))
(define dual (vector-basis->dual (list->down e) Euler-angles))

;; [e_i, e_j] = c^k_ij e_k
(define (c k i j) ((ref dual k) (commutator (list-ref e i) (list-ref e j))))
((c 2 0 1) ((point Euler-angles) (up 'theta 'phi 'psi)))

;; Two fields with unknown components
(define (combined components) (apply + (map * components e)))
(define (unknown . names)
  (for/list ([name names]) (literal-manifold-function name Euler-angles)))
(define-values (us vs) (values (unknown 'u^0 'u^1 'u^2) (unknown 'v^0 'v^1 'v^2)))
(define-values (u v) (values (combined us) (combined vs)))

;; By Leibniz: what the fields make of each other's components, and what the basis leaves
(define derived
  (combined (for/list ([u_k us] [v_k vs]) (- (u v_k) (v u_k)))))
(define left-by-basis
  (combined (for/list ([k 3])
              (apply + (for*/list ([i 3] [j 3]) (* (list-ref us i) (list-ref vs j) (c k i j)))))))
(define right (verify-equal (commutator u v) (+ derived left-by-basis)))
right

;; The slip: as on a basis of coordinates, whose fields commute
(define wrong (verify-equal (commutator u v) derived))
(verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "with structure constants"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-pred proved? (verify-equal (c 2 0 1) -1))))
