#lang racket/base
;; Motions on manifolds that a program makes, and free motion on the group of rotations.

(require mechanics mechanics/geometry
         "../support/checks.rkt" "../support/close.rkt")

;; ---------------------------------------------------------------------------
;; The torus that a circle of radius 1 sweeps at the distance 2: two angles; and, of its outer upper
;; part, the rectangular x and y.

(define torus-type (make-manifold-type 'torus 'everywhere 'upper))

(attach-coordinate-system
 'angles 'everywhere torus-type
 (lambda (n)
   (lambda (x)
     (define-values (u v) (values (ref x 0) (ref x 1)))
     (define rho (+ 2 (cos u)))
     (up (* rho (cos v)) (* rho (sin v)) (sin u))))
 (lambda (n)
   (lambda (place)
     (define-values (x y z) (values (ref place 0) (ref place 1) (ref place 2)))
     (up (atan z (- (sqrt (+ (square x) (square y))) 2)) (atan y x))))
 #:dimensions '(2) #:names (lambda (n) '(u v)))

(attach-coordinate-system
 'from-above 'upper torus-type
 (lambda (n)
   (lambda (q)
     (define-values (x y) (values (ref q 0) (ref q 1)))
     (up x y (sqrt (- 1 (square (- (sqrt (+ (square x) (square y))) 2)))))))
 (lambda (n) (lambda (place) (up (ref place 0) (ref place 1))))
 #:dimensions '(2) #:names (lambda (n) '(x y)))

(define torus (make-manifold torus-type 2))
(define angles (coordinate-system-at 'angles 'everywhere torus))
(define from-above (coordinate-system-at 'from-above 'upper torus))

;; A free particle, and its motion in space: the acceleration is along the normal.
(define (L-free local)
  (define u (ref (coordinate local) 0))
  (* 1/2 (+ (square (ref (velocity local) 0))
            (square (* (+ 2 (cos u)) (ref (velocity local) 1))))))

(define (in-space q)
  (define rho (+ 2 (cos (ref q 0))))
  (up (* rho (cos (ref q 1))) (* rho (sin (ref q 1))) (sin (ref q 0))))

(define (space-rates state)
  (define (f p) (+ (square (- (sqrt (+ (square (ref p 0)) (square (ref p 1)))) 2))
                   (square (ref p 2))))
  (define-values (p v) (values (coordinate state) (velocity state)))
  (define n ((D f) p))
  (define (along p) (* ((D f) p) v))
  (define lambda (/ (* ((D along) p) v) (square n)))
  (up 1 v (* -1 lambda (up (ref n 0) (ref n 1) (ref n 2)))))

(define (check-torus tr start end)
  (define oracle
    (evolve-trajectory space-rates ((F->C (lambda (s) (in-space (coordinate s)))) start) end
                       #:tolerance 1e-13))
  (for ([k 11])
    (define t (* end (/ k 10)))
    (check-close (in-space (coordinate (tr t))) (coordinate (oracle t)) 1e-10)))

(test-case "a particle on a torus, with Clairaut's constant"
  (define start (up 0 (up 0.4 0.1) (up 0.7 0.5)))
  (define tr (evolve-on L-free angles start 10 #:tolerance 1e-13))
  (check-torus tr start 10)
  (for ([t 11])
    (check-close (ref (trajectory-momentum tr t) 1) (* (square (+ 2 (cos 0.4))) 0.5) 1e-11)))

(test-case "the torus seen from above is left where its coordinates end"
  (define start (up 0 (up 0.8 0.1) (up -0.7 0.5)))
  (define there ((F->C (lambda (s) (let ([p (in-space (coordinate s))]) (up (ref p 0) (ref p 1)))))
                 start))
  (define tr
    (evolve-on L-free angles (up 0 ((point from-above) (coordinate there)) (velocity there)) 10
               #:tolerance 1e-13))
  (check-equal? (cadr (car (trajectory-chart-changes tr))) from-above)
  (check-torus tr start 10))

(test-case "a circle needs no other chart"
  (define tr (evolve-on (lambda (s) (* 1/2 (square (velocity s)))) S1-circular (up 0 1.0 2.0) 10))
  (check-close (tr 10) (up 10 21.0 2.0) 1e-9)
  (check-equal? (trajectory-chart-changes tr) '()))

(test-case "the plane through its origin: polar angles turn by half a turn"
  (define (L-polar s)
    (define-values (q v) (values (coordinate s) (velocity s)))
    (* 1/2 (+ (square (ref v 0)) (square (* (ref q 0) (ref v 1))))))
  (define tr (evolve-on L-polar R2-polar (up 0 (up 1.0 0.5) (up -1.0 0.0)) 3))
  (check-close ((chart R2-rect) (trajectory-point tr 3)) (* -2 (up (cos 0.5) (sin 0.5))) 1e-10)
  (check-close (coordinate (tr 3)) (up 2 (- 0.5 pi)) 1e-10)
  (define near (evolve-on L-polar R2-polar (up 0 (up 1.0 0.0) (up -1.0 1e-6)) 3))
  (check-close (ref (coordinate (near 3)) 1) (- pi 1e-6 5e-7) 1e-9))

;; ---------------------------------------------------------------------------
;; SO(3) with the metric that all rotations keep: geodesics are rotations at a constant rate about
;; an axis that stays, M(t) = exp(Ω t) M(0).

(define (rotation-about axis angle)     ; Rodrigues
  (define-values (x y z) (values (ref axis 0) (ref axis 1) (ref axis 2)))
  (define K (matrix-by-rows (list 0 (- z) y) (list z 0 (- x)) (list (- y) x 0)))
  (define one (matrix-by-rows '(1 0 0) '(0 1 0) '(0 0 1)))
  (+ one (* (sin angle) K) (* (- 1 (cos angle)) (* K K))))

(test-case "free motion on SO(3) through θ = 0 and θ = π is a rotation about one axis"
  (define L (T-rigid-body 1 1 1))
  (define start (up 0 (up 0.5 0.2 0.1) (up -1.0 0.0 0.0)))
  (for ([start (list start (up 0 (up 0.5 0.2 0.1) (up -1.0 0.3 0.2)))])
    (define omega (Euler-state->omega-space start))
    (define rate (sqrt (square omega)))
    (define tr (evolve-on L Euler-angles start 10 #:tolerance 1e-13))
    (for ([t 11])
      (define turned (* (rotation-about (/ omega rate) (* rate t)) (Euler->M (coordinate start))))
      (define M (Euler->M (coordinate (tr t))))
      (for* ([i 3] [j 3]) (check-close (matrix-ref M i j) (matrix-ref turned i j) 1e-10)))))

(test-case "the same by the metric that SO(3) has among the matrices"
  (define start (up 0 (up 0.5 0.2 0.1) (up -1.0 0.3 0.2)))
  (define tr (evolve-geodesic (coordinate-system->metric Euler-angles) Euler-angles start 5
                              #:tolerance 1e-13))
  (define same (evolve-on (T-rigid-body 1 1 1) Euler-angles start 5 #:tolerance 1e-13))
  (check-close (tr 5) (same 5) 1e-10))
