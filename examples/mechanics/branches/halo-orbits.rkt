#lang mechanics
;; Near the point L1 between Earth and Moon there are orbits in the plane of the Moon's motion
;; (Lyapunov's), one for each energy.  With more energy they lose their stability across the plane,
;; and halo orbits leave them, seen from Earth as rings about the Moon.

(define mu 0.012150585609624)
(define (H (up t (up x y z) (down px py pz)))
  (define (pull mass at) (/ mass (sqrt (+ (square (- x at)) (square y) (square z)))))
  (- (+ (* 1/2 (+ (square px) (square py) (square pz))) (* y px) (* -1 x py))
     (pull (- 1 mu) (- mu))
     (pull mu (- 1 mu))))
(define motion (Hamiltonian->state-derivative H))

(define small
  (find-periodic-orbit motion (up 0 (up 0.8269 0 0) (down 0 0.9106 0)) 2.69 #:energy H))
(define planar
  (continue-periodic-orbit motion (periodic-orbit-state small) (periodic-orbit-period small)
                           (H (periodic-orbit-state small)) -1.58 #:energy H))
planar
(define fork (car (branch-special-points planar)))

;; Jacobi's constant, as astronomers have it
(* -2 (special-point-parameter fork))

(define halo (switch-branch planar fork #:most-steps 40))
halo

;; The smallest halo orbit of JPL's catalog of periodic orbits of three bodies, of the same mu
;; (https://ssd.jpl.nasa.gov/tools/periodic_orbits.html, Earth and Moon, number 1147): x, z and the
;; velocity along y; the period; Jacobi's constant
(define-values (x z rate-of-y)
  (values 0.82339081983651485 9.8941366235910004e-4 0.12634272983881797))
(define-values (catalog-period catalog-constant) (values 2.7430007981241529 3.1743435193301202))
(define smallest
  (find-periodic-orbit motion (up 0 (up x 0 z) (down 0 (+ rate-of-y x) 0)) catalog-period
                       #:energy H))
smallest

(module+ test
  (require rackunit)
  ;; That constant by other means: from axis to axis by Runge and Kutta's method, then Hill's
  ;; equation across the plane, of which the trace becomes 2
  (test-case "the halo orbits begin where Hill's equation has the trace 2"
    (check-eq? (special-point-kind fork) 'pitchfork)
    (check-= (* -2 (special-point-parameter fork)) 3.1743519541 1e-9))
  (test-case "the orbit of the catalog is found again, and lies on the branch"
    (define constant (* -2 (H (periodic-orbit-state smallest))))
    (check-= (periodic-orbit-period smallest) catalog-period 1e-8)
    (check-= constant catalog-constant 1e-9)
    ;; Close to the fork the constant falls as the square of z.
    (define (fall constant z) (/ (- (* -2 (special-point-parameter fork)) constant) (square z)))
    (define-values (E last) (values (car (reverse (branch-parameters halo)))
                                    (car (reverse (branch-states halo)))))
    (check-= (/ (fall (* -2 E) (ref last 1 2)) (fall catalog-constant z)) 1 3e-3))
  (test-case "they keep their energy, come back, and leave the plane"
    (define state (car (reverse (branch-states halo))))
    (define end
      ((state-advancer (lambda () motion)) state (car (reverse (branch-periods halo)))))
    (check-= (magnitude (- (coordinate end) (coordinate state))) 0 1e-7)
    (check-true (> (abs (ref state 1 2)) 1e-3))))
