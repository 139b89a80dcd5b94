#lang mechanics
;; A free rigid body: what is conserved, Poinsot's picture of it, and the motion in elliptic
;; functions (SICM 2.8 and 2.9).

(require mechanics/plot)
(provide picture)

(define state (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))
(define T (T-body-Euler 'A 'B 'C))

;; Energy and angular momentum do not change.
(map verdict-status
     (list (verify-conserved T T state)
           (verify-conserved T (L-space-Euler 'A 'B 'C) state)))

;; Poinsot: the ellipsoid ω·I ω = 2 T, carried by the body, rolls on a plane that stays.  Its
;; distance from the centre is along L: the part of ω along L is 2 T/|L|, for ω·L = 2 T.
(define omega (Euler-state->omega-space state))
(define height (verify-equal (* ((L-space-Euler 'A 'B 'C) state) omega) (* 2 (T state))))
height

;; With numbers: the body of the book's figure, quaternions for its orientation.
(define-values (A B C) (values 1. (sqrt 2.) 2.))
(define start (up 0 (up 1. 0 0 0) (up 0.1 0 0.1)))
(define body (evolve-trajectory (qw-sysder A B C) start 200 #:tolerance 1e-13))

;; Where the ellipsoid touches the plane: ω in space, across L.
(define L0 ((qw-state->L-space A B C) start))
(define size (sqrt (square L0)))
(define axis (up (/ (ref L0 0) size) (/ (ref L0 1) size) (/ (ref L0 2) size)))
(define across (cross-product axis (up 0 1 0)))
(define along (cross-product axis across))
(define (omega-in-space s)
  (* (quaternion->rotation-matrix (make-quaternion (coordinate s))) (ref s 2)))
(define (touching t)
  (define w (omega-in-space (body t)))
  (up (dot-product w across) (dot-product w along)))

(define picture
  (frame -0.05 0.05 -0.05 0.05 #:width 400 #:height 400))
(plot-parametric picture touching 0. 200. 0.5)
picture

;; The motion on the body is one of Jacobi's functions.  Here 2 E B < L², and ω_b = 0 at first.
(define E ((T-body A B C) (ref start 2)))
(define L^2 (square L0))
(define rate (sqrt (/ (* (- C B) (- L^2 (* 2 E A))) (* A B C))))
(define k (sqrt (/ (* (- B A) (- (* 2 E C) L^2)) (* (- C B) (- L^2 (* 2 E A))))))
(define (exact t)
  (define (amplitude m x) (sqrt (/ x m)))
  (Jacobi-elliptic-functions
   (* rate t) k
   (lambda (sn cn dn)
     (up (* cn (amplitude (* A (- C A)) (- (* 2 E C) L^2)))
         (* sn (amplitude (* B (- C B)) (- (* 2 E C) L^2)))
         (* dn (amplitude (* C (- C A)) (- L^2 (* 2 E A))))))))
(define (off t) (sqrt (square (- (ref (body t) 2) (exact t)))))
(for/and ([t '(0 1 10 100 200)]) (< (off t) 1e-12))

(module+ main
  (require "../figures/save.rkt")
  (save-figure picture "free-body.png"))

(module+ test
  (require rackunit)
  (test-case "the plane stays where it is"
    (check-pred proved? height)
    (for ([t (in-range 0 201 10)])
      (check-= (dot-product (omega-in-space (body t)) axis) (/ (* 2 E) size) 1e-14)))
  (test-case "the exact solution"
    (check-true (< (* 2 E B) L^2))
    (for ([t (in-range 0 201 10)]) (check-= (off t) 0 1e-12)))
  (test-case "the ellipsoid touches between two circles"
    (define distances (for/list ([t (in-range 0. 200. 0.5)]) (sqrt (square (touching t)))))
    (check-= (apply min distances) 0.02314 1e-5)
    (check-= (apply max distances) 0.04472 1e-5)
    (check-equal? (length (frame-curves picture)) 1)))
