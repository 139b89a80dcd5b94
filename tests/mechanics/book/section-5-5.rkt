#lang racket/base
;; SICM 5.5 and 5.6, Extended and Reduced Phase Space (pp. 394-407).

(require mechanics
         mechanics/book
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define polar (up 't (up 'r 'theta) (down 'p_r 'p_theta)))
(define extended (up 's (up 't (up 'r 'theta)) (down 'p_t (down 'p_r 'p_theta))))
(define H3 (H-restricted-three-body 'm 'G 'm_1 'm_2 'a))
(define Omega (sqrt (/ (* 'G (+ 'm_1 'm_2)) (expt 'a 3))))
(define F (rotating-polar Omega))
(define turning-H (+ (compose H3 (F->CH F)) (F->K F)))

(test-case "pp. 399-400: in turning coordinates Jacobi's constant is conserved"
  (check-identity (((partial 0) turning-H) polar) 0)
  (check-pred proved? (verify-conserved turning-H turning-H polar))
  (check-pred refuted? (verify-conserved H3 H3 polar)))

(test-case "pp. 401-402: the other way, by the extended phase space"
  (define C (extended-transformation (F->CH F) (F->K F)))
  (check-identity ((compose (extended-Hamiltonian H3) C) extended)
                  (+ 'p_t (turning-H polar)))
  (check-identity (ref (momentum (C extended)) 0) (- 'p_t (* Omega 'p_theta))))

(test-case "the same energy as the Lagrangian's on turning axes (1.8.4), in rectangular ones"
  (define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))
  (define L (LR3B 1 'a 'GM_0 'GM_1))
  (define H ((Lagrangian->Hamiltonian L) plane))
  (define point '(x 0.3 y 0.7 p_x 0.2 p_y -0.4 a 1.3))
  (define rectangular (apply substitute H 'GM_0 0.8 'GM_1 0.25 point))
  (define there (substitute ((F->CH r->p) plane) 'x 0.3 'y 0.7 'p_x 0.2 'p_y -0.4 't 0))
  (define polar-H
    (let ([H (H-restricted-three-body 1.0 1.0 0.8 0.25 1.3)]
          [Omega (sqrt (/ 1.05 (expt 1.3 3)))])
      (- (H there) (* Omega (ref (momentum there) 1)))))
  (check-close (expression (simplify rectangular)) polar-H 1e-12))

;; Exercise 5.19
(test-case "p. 402: K is right if the extended transformation is symplectic"
  (define C (F->CH (rotating-polar 'Omega)))
  (check-pred proved? (verify-canonical
                       (extended-transformation C (F->K (rotating-polar 'Omega))) extended))
  (check-pred refuted? (verify-canonical (extended-transformation C (lambda (s) 0)) extended))
  ;; what K may get beside: the time and constants
  (check-pred proved? (verify-canonical
                       (extended-transformation C
                                                (+ (F->K (rotating-polar 'Omega))
                                                   (compose sin time)))
                       extended)))

(test-case "pp. 405-406: the orbit in a central field by the radius for time"
  (define H (H-central-polar 'm (literal-function 'V)))
  (define H-r (reduced-Hamiltonian H 0 'E))
  (define state (up 'r 'phi 'p_phi))
  (check-identity (H-r state)
                  (- (sqrt (- (* 2 'm (- 'E ((literal-function 'V) 'r)))
                              (/ (square 'p_phi) (square 'r))))))
  (check-identity (ref ((Hamiltonian->state-derivative H-r) state) 2) 0)
  (check-identity ((reduced-Hamiltonian H 0 'E #:backwards? #t) state) (- (H-r state)))
  (check-identity ((state->reduced-state 0) polar) (up 'r 'theta 'p_theta)))

;; Hamilton's equations there are those along the orbit, divided by the coordinate's.
(test-case "p. 404: the reduced motion is the motion"
  (define H (compose (H-central 1 (lambda (r) (/ -1 r))) (F->CH p->r)))
  (define s (up 0.0 (up 1.0 0.3) (down 0.4 1.1)))
  (define rate ((Hamiltonian->state-derivative H) s))
  (define reduced ((Hamiltonian->state-derivative (reduced-Hamiltonian H 0 (H s)))
                   ((state->reduced-state 0) s)))
  (check-close (ref reduced 1) (/ (ref rate 1 1) (ref rate 1 0)) 1e-12)
  (check-close (ref reduced 2) (/ (ref rate 2 1) (ref rate 1 0)) 1e-12))

(test-case "of three coordinates the others stay together"
  (define space (up 't (up 'x 'y 'z) (down 'p_x 'p_y 'p_z)))
  (define (H s) (+ (/ (square (momentum s)) (* 2 'm)) (* 'g (ref s 1 2))))
  (check-identity ((state->reduced-state 1) space) (up 'y (up 'x 'z) (down 'p_x 'p_z)))
  (check-identity ((reduced-Hamiltonian H 1 'E) (up 'y (up 'x 'z) (down 'p_x 'p_z)))
                  (- (sqrt (- (* 2 'm (- 'E (* 'g 'z))) (square 'p_x) (square 'p_z))))))

;; ---------------------------------------------------------------------------
;; Exercise 5.21: several bodies

(define (bodies n)
  (define (named mark) (for/list ([i n]) (string->symbol (format "~a~a" mark i))))
  (up 't (list->up (named "x")) (list->down (named "p"))))
(define masses '(m0 m1 m2 m3 m4 m5))
(define ((kinetic ms) s)
  (apply + (for/list ([m ms] [i (in-naturals)]) (/ (square (ref (momentum s) i)) (* 2 m)))))

(test-case "links are canonical and keep the kinetic energy a sum of squares"
  (define links '((0 1) (1 2) (3 4) (4 5) (2 5)))     ; two triples, each a pair and a third
  (define C (linked-canonical masses links))
  (check-pred proved? (verify-canonical C (bodies 6)))
  (check-identity ((compose (kinetic masses) C) (bodies 6))
                  ((kinetic (linked-masses masses links)) (bodies 6)))
  (check-equal? (center-of-mass-of-links 6 links) 5)
  (define new (coordinate ((linked-canonical-inverse masses links) (bodies 6))))
  (check-identity (* (apply + masses) (ref new 5)) (* (list->down masses) (coordinate (bodies 6))))
  (check-identity ((compose C (linked-canonical-inverse masses links)) (bodies 6)) (bodies 6)))

(test-case "Jacobi's coordinates: each body from the centre of mass of those before"
  (define C-inv (linked-canonical-inverse '(m0 m1 m2) (Jacobi-links 3)))
  (check-equal? (Jacobi-links 4) '((0 1) (1 2) (2 3)))
  (check-identity (coordinate (C-inv (bodies 3)))
                  (up (- 'x1 'x0)
                      (- 'x2 (/ (+ (* 'm0 'x0) (* 'm1 'x1)) (+ 'm0 'm1)))
                      (/ (+ (* 'm0 'x0) (* 'm1 'x1) (* 'm2 'x2)) (+ 'm0 'm1 'm2)))))

(test-case "two bodies: scmutils' centre of mass, its coordinates the other way round"
  (define two (bodies 2))
  (define old ((linked-canonical-inverse '(m0 m1) '((0 1))) two))
  (define scmutils ((two-particle-center-of-mass-canonical 'm0 'm1) two))
  (check-identity (up (ref (coordinate old) 1) (ref (coordinate old) 0)) (coordinate scmutils))
  (check-identity (down (ref (momentum old) 1) (ref (momentum old) 0)) (momentum scmutils)))

(test-case "a way that is linked again is no body: no coordinate is the centre of mass"
  (check-false (center-of-mass-of-links 3 '((0 1) (0 2))))
  (check-false (center-of-mass-of-links 3 '((0 1))))
  (check-pred proved? (verify-canonical (linked-canonical '(m0 m1 m2) '((0 1) (0 2))) (bodies 3))))

(test-case "heliocentric coordinates: canonical, and the kinetic energy is no sum of squares"
  (define C (heliocentric-canonical '(m0 m1 m2)))
  (check-pred proved? (verify-canonical C (bodies 3)))
  (check-identity ((compose C (heliocentric-canonical-inverse '(m0 m1 m2))) (bodies 3)) (bodies 3))
  (define T ((compose (kinetic '(m0 m1 m2)) C) (bodies 3)))
  (check-identity (substitute (coefficient (expand T) 'p1 1) 'p0 0) (/ 'p2 'm0))
  (check-identity (coordinate ((heliocentric-canonical-inverse '(m0 m1 m2)) (bodies 3)))
                  (up (/ (+ (* 'm0 'x0) (* 'm1 'x1) (* 'm2 'x2)) (+ 'm0 'm1 'm2))
                      (- 'x1 'x0) (- 'x2 'x0))))

(test-case "bodies in space"
  (define two (up 't (up (up 'x 'y) (up 'u 'v)) (down (down 'p_x 'p_y) (down 'p_u 'p_v))))
  (check-pred proved? (verify-canonical (linked-canonical '(1 3) '((0 1))) two))
  (check-pred proved? (verify-canonical (heliocentric-canonical '(1 3)) two)))

;; ---------------------------------------------------------------------------
;; Mistakes

(define (H-time s) (+ (square (ref s 2 0)) (square (ref s 2 1)) (* (time s) (ref s 1 0))))
(define (H-flat s) (+ (square (ref s 2 0)) (ref s 1 1)))

(says
 [((reduced-Hamiltonian H-time 0 'E) (up 'r 'phi 'p_phi))
  "reduced-Hamiltonian: H-time depends on the time; extended-Hamiltonian makes the time a "
  "coordinate first"]
 [((reduced-Hamiltonian H-flat 1 'E) (up 'r 'phi 'p_phi))
  "reduced-Hamiltonian: H-flat does not depend on the momentum of index 1, which it cannot give"]
 [((reduced-Hamiltonian (lambda (s) (+ (expt (ref s 2 0) 3) (ref s 2 1))) 0 'E) (up 'r 'phi 'p_phi))
  "reduced-Hamiltonian: the momentum of index 0 is found where <function> is of degree 1 or 2 in it"]
 [((reduced-Hamiltonian H-flat 5 'E) (up 'r 'phi 'p_phi))
  "reduced-Hamiltonian: the reduced state (up x q p) has 1 coordinate beside the one of index 5, "
  "which comes from a state of more; given (up r phi p_phi), an up tuple of 3"]
 [(reduced-Hamiltonian H-flat 'r 'E)
  "reduced-Hamiltonian: expected the index of a coordinate\n  given: the symbol r"]
 [((state->reduced-state 2) polar)
  "state->reduced-state: there is no coordinate of index 2 beside others; given "
  "(up t (up r theta) (down p_r p_theta)), an up tuple of 3"]
 [(linked-canonical '(1 2) '((0 0)))
  "linked-canonical: links are a list of pairs of different bodies, by their numbers from 0 on, "
  "such as ((0 1) (1 2)); given ((0 0))"]
 [(linked-masses '(1 2 3) '((0 3)))
  "linked-masses: the link (0 3) names a body that is not there: 3 bodies have the numbers 0 to 2"]
 [((linked-canonical '(1 2 3) '((0 1))) (bodies 2))
  "linked-canonical: expected the state of 3 bodies, as there are 3 masses: "
  "(up t (up x0 x1 ...) (down p0 p1 ...)); given (up t (up x0 x1) (down p0 p1)), an up tuple of 3"]
 [(heliocentric-canonical 'm)
  "heliocentric-canonical: expected the masses of the bodies, a list of at least two\n  given: the "
  "symbol m"]
 [(Jacobi-links 1)
  "Jacobi-links: expected a number of bodies, at least 2\n  given: the number 1"])
