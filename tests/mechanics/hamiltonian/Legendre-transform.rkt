#lang racket/base
;; Legendre transforms: exact ones, formulas, numbers, and where there is none.

(require mechanics
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt"
         "../support/systems.rkt")

(define plane (up 't (up 'x 'y) (up 'vx 'vy)))
(define phase (up 't (up 'x 'y) (down 'p_x 'p_y)))

;; H by numbers, from p v − L at the velocities v.
(define (check-transform L local)
  (define H (Lagrangian->Hamiltonian L))
  (define state ((Lstate->Hstate L) local))
  (check-close (list (H state) (coordinate ((Hstate->Lstate H) state))
                     (velocity ((Hstate->Lstate H) state)))
               (list ((Lagrangian->energy L) local) (coordinate local) (velocity local))
               1e-9))

;; ---------------------------------------------------------------------------
;; Quadratic ones

(test-case "a double pendulum, exactly"
  (define L (L-double-pendulum 'm1 'm2 'l1 'l2 'g))
  (define local (up 't (up 'a 'b) (up 'va 'vb)))
  (define H (Lagrangian->Hamiltonian L))
  (check-identity (H ((Lstate->Hstate L) local)) ((Lagrangian->energy L) local))
  (check-identity ((Hamiltonian->Lagrangian H) local) (L local))
  (check-transform (L-double-pendulum 1. 2. 1.5 0.5 9.8) (up 0. (up .3 -.7) (up 1.1 -.4))))

(test-case "velocities in linear terms: a magnetic field"
  (define ((L-field m q B) (up t (up x y) (up vx vy)))
    (+ (* 1/2 m (+ (square vx) (square vy))) (* 1/2 q B (- (* x vy) (* y vx)))))
  (check-identity ((Lagrangian->Hamiltonian (L-field 'm 'q 'B)) phase)
                  (/ (+ (square (+ 'p_x (* 1/2 'q 'B 'y))) (square (- 'p_y (* 1/2 'q 'B 'x))))
                     (* 2 'm))))

(test-case "quadratic after simplification only"
  (define (F v) (* 'm (- (square (+ 'u v)) (square (sin v)) (square (cos v)))))
  (check-identity ((Legendre-transform F) 'w)
                  (+ (/ (square 'w) (* 4 'm)) (* -1 'u 'w) 'm)))

(test-case "the derivatives of a transform are those of the inverse function"
  (define L (L-double-pendulum 'm1 'm2 'l1 'l2 'g))
  (define H (Lagrangian->Hamiltonian L))
  (define state (up 't (up 'a 'b) (down 'p_a 'p_b)))
  ;; as H says itself, and as the state derivative finds it
  (define slope ((Hamiltonian->state-derivative H) state))
  (check-identity (ref slope 1) (((partial 2) H) state))
  (check-identity (ref slope 2) (- (((partial 1) H) state))))

;; ---------------------------------------------------------------------------
;; Formulas

(define ((L-relativistic m c) (up t q v))
  (* -1 m (square c) (sqrt (- 1 (/ (square v) (square c))))))

(define (energy-of p) (sqrt (+ (* (square p) (square 'c)) (* (square 'm) (expt 'c 4)))))

(test-case "a relativistic particle on a line: √(p²c² + m²c⁴)"
  (define H (Lagrangian->Hamiltonian (L-relativistic 'm 'c)))
  (check-identity (H (up 't 'q 'p)) (energy-of 'p))
  (check-identity (((partial 2) H) (up 't 'q 'p)) (/ (* 'p (square 'c)) (energy-of 'p))))

(test-case "the formula holds for a negative m, too: the momentum is opposite to the velocity"
  (define slope ((Hamiltonian->state-derivative (Lagrangian->Hamiltonian (L-relativistic 'm 'c)))
                 (up 't 'q 'p)))
  (check-close (substitute (ref slope 1) 'm -2.0 'c 3.0 'p 1.0)
               (/ -3.0 (sqrt (+ 36.0 1.0))) 1e-12)
  (check-pred refuted?
              (assuming ('(< m 0))
                (verify-equal ((Lagrangian->Hamiltonian (L-relativistic 'm 'c)) (up 't 'q 'p))
                              (energy-of 'p)))))

(test-case "in the plane, and back"
  (define H (Lagrangian->Hamiltonian (L-relativistic 'm 'c)))
  (check-identity (H phase) (energy-of (down 'p_x 'p_y)))
  (check-identity ((Hamiltonian->Lagrangian H) plane) ((L-relativistic 'm 'c) plane)))

(test-case "in polar coordinates, in a field"
  (define ((L-orbit m c q A U) (up t (up r phi) (up vr vphi)))
    (+ (* -1 m (square c)
          (sqrt (- 1 (/ (+ (square vr) (square (* r vphi))) (square c)))))
       (* q (A r) vphi)
       (* -1 (U r))))
  (define-values (A U) (values (literal-function 'A) (literal-function 'U)))
  (check-identity ((Lagrangian->Hamiltonian (L-orbit 'm 'c 'q A U))
                   (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
                  (+ (U 'r)
                     (* 'c (sqrt (+ (square (* 'm 'c)) (square 'p_r)
                                    (square (/ (- 'p_phi (* 'q (A 'r))) 'r))))))))

(test-case "coordinates of different kinds are solved apart"
  (define ((L-both) (up t (up x y) (up vx vy)))
    (+ (* 1/2 'M (square vx)) (* x vx) ((L-relativistic 'm 'c) (up t y vy))))
  (check-identity ((Lagrangian->Hamiltonian (L-both)) phase)
                  (+ (/ (square (- 'p_x 'x)) (* 2 'M)) (energy-of 'p_y))))

(test-case "of two solutions that which has no velocity without momentum"
  (define ((L-cubic) (up t q v)) (+ (* 1/2 (square v)) (* 1/3 (expt v 3))))
  (check-identity (((partial 2) (Lagrangian->Hamiltonian (L-cubic))) (up 't 'q 'p))
                  (/ (- (sqrt (+ 1 (* 4 'p))) 1) 2)))

(test-case "a formula that rests on declared assumptions is not kept under others"
  ;; |a| (v² + v³) has the slope |a| (2 v + 3 v²)
  (define v
    (D (Legendre-transform (lambda (v) (* (sqrt (square 'a)) (+ (square v) (expt v 3)))))))
  (define (at-one a) (substitute (simplify (v 'w)) 'a a 'w 8.0))
  (check-close (assuming ('(> a 0)) (at-one 1.0)) 4/3 1e-12)
  (check-close (assuming ('(< a 0)) (at-one -1.0)) 4/3 1e-12))

(test-case "numbers agree with the formula"
  (check-transform (L-relativistic 1.5 2.0) (up 0. (up 1. 2.) (up .3 -.9)))
  (define H (Lagrangian->Hamiltonian (L-relativistic 1.5 2.0)))
  (check-close ((Hamiltonian->state-derivative H) (up 0 1.0 0.7))
               (up 1 (/ (* .7 4) (sqrt (+ (* .49 4) (* 2.25 16)))) 0.0)
               1e-12))

;; ---------------------------------------------------------------------------
;; Numbers

(define ((L-quartic) (up t q v)) (+ (* 1/4 (expt v 4)) (* 1/2 (square v)) (* 1/2 q v)))

(test-case "a transform without a formula, and its derivatives"
  ;; p = v³ + v + q/2: at p = 3, q = 2 v = 1
  (define H (Lagrangian->Hamiltonian (L-quartic)))
  (check-close (H (up 0. 2. 3.)) (- 3 1/4 1/2 1) 1e-10)
  (check-close ((D H) (up 0. 2. 3.)) '(0 -1/2 1) 1e-9)
  ;; ∂²H/∂p² = 1/(3v² + 1)
  (check-close (((partial 2) ((partial 2) H)) (up 0. 2. 3.)) 1/4 1e-8)
  (check-transform (L-quartic) (up 0. 2. -.8)))

(define ((only-numbers m) (up t q v))
  (if (> v 100) 0.0 (* 1/2 m (square v))))

(test-case "a Lagrangian that decides something by a number"
  (define H (Lagrangian->Hamiltonian (only-numbers 2.0)))
  (check-close (H (up 0 1.0 3.0)) 9/4 1e-10))

(test-case "such a system moves"
  (define (system) (Hamiltonian->state-derivative (Lagrangian->Hamiltonian (L-quartic))))
  (define end ((state-advancer system) (up 0.0 1.0 1.5) 0.5 1e-10))
  (define H (Lagrangian->Hamiltonian (L-quartic)))
  (check-close (H end) (H (up 0.0 1.0 1.5)) 1e-8))

;; ---------------------------------------------------------------------------
;; Where there is none

(define no-inverse "the second derivatives have no inverse; ")

(define-syntax-rule (fails-with text expression)
  (check-message text expression exn:fail:mechanics:singular:matrix?))

(test-case "directions without inertia are named"
  (define ((L-missing m) (up t q (up vx vy))) (* 1/2 m (square (- vx vy))))
  (fails-with
   (string-append "Lagrangian->Hamiltonian: " no-inverse
                  "velocities do not follow from momenta\n"
                  "  no inertia in the direction: (up 1 1)\n"
                  "  second derivatives: (down (down m (* -1 m)) (down (* -1 m) m))")
   ((Lagrangian->Hamiltonian (L-missing 'm)) phase))
  (check-equal?
   (with-handlers ([exn:fail:mechanics:singular:matrix?
                    exn:fail:mechanics:singular:matrix-null-vectors])
     ((Lagrangian->Hamiltonian (L-missing 'm)) phase))
   (list (up 1 1))))

(test-case "a coordinate of which the velocity does not occur"
  (fails-with
   (string-append "Lagrangian->Hamiltonian: " no-inverse
                  "velocities do not follow from momenta\n"
                  "  no inertia in the direction: (up 0 1)\n"
                  "  second derivatives: (down (down m 0) (down 0 0))")
   ((Lagrangian->Hamiltonian (lambda (s) (* 1/2 'm (square (ref (velocity s) 0))))) phase)))

(test-case "a transform by proper time has none: L is of first degree in the velocities"
  (define (L s) (* 'm (sqrt (- (square (ref (velocity s) 0)) (square (ref (velocity s) 1))))))
  (check-exn (lambda (e)
               (and (exn:fail:mechanics:singular:matrix? e)
                    (regexp-match? #rx"no inertia in the direction" (exn-message e))))
             (lambda () ((Lagrangian->Hamiltonian L) phase))))

(test-case "a Hamiltonian that has no velocities"
  (fails-with
   (string-append "Hamiltonian->Lagrangian: " no-inverse
                  "momenta do not follow from velocities\n"
                  "  the same velocity in the direction: 1\n"
                  "  second derivatives: 0")
   ((Hamiltonian->Lagrangian (lambda (s) (* 'c (momentum s)))) (up 't 'q 'v))))

(says
 [((Lagrangian->Hamiltonian (L-quartic)) (up 't 'q 'p))
  "Lagrangian->Hamiltonian: no formula was found for the velocities, and numbers are not found "
  "with symbols left\n  one of them: p\n  give the parameters and the state as numbers"]
 [(Legendre-transform 3)
  "Legendre-transform: expected a function of one argument, the velocities; given the number 3"]
 [((Legendre-transform (lambda (v) (up v v))) 'w)
  "Legendre-transform: the value of a function to be transformed is a number, but that of "
  "<function> is (up 0 0), an up tuple of 2"]
 [((Hamiltonian->Lagrangian (lambda (s) (square (momentum s)))) (up 't (up 'x 'y) (down 'a 'b)))
  "Hamiltonian->Lagrangian: the velocities are of another shape than the coordinates\n"
  "  coordinates: (up x y)\n  velocities: (down a b)"]
 [((Lstate->Hstate (lambda (s) (square (velocity s)))) (up 't 'x))
  "Lstate->Hstate: expected a local tuple (up t q v ...); given (up t x), an up tuple of 2"])

(test-case "an unknown Lagrangian has no formula, and no numbers"
  (for ([state (list (up 't 'q 'p) (up 0 1.0 2.0))])
    (check-exn #rx"^Lagrangian->Hamiltonian: no formula was found for the velocities"
               (lambda ()
                 ((Lagrangian->Hamiltonian (literal-function 'L (Lagrangian 1))) state)))))

(test-case "momenta that no velocity has"
  (check-message "Legendre-transform: no velocities were found for -2.0"
                 ((Legendre-transform exp) -2.0)
                 exn:fail:mechanics:not-convergent?)
  (check-close ((Legendre-transform exp) 2.0) (- (* 2 (log 2)) 2) 1e-12))

(test-case "functions that are flat at rest"
  (check-close ((Legendre-transform (lambda (v) (expt v 4))) 4.0) 3 1e-10)
  (check-close ((Legendre-transform (lambda (v) (expt v 4))) -4.0) 3 1e-10))

(test-case "what is quadratic on each side only is not taken for quadratic"
  ;; v |v| / 2 + v² has the slopes 3 v and v
  (define (F v) (+ (* 1/2 v (sqrt (square v))) (square v)))
  (define G (Legendre-transform F))
  (check-close (list (G 3.0) (G -3.0)) '(3/2 9/2) 1e-10))

(test-case "particles with nested coordinates"
  (define ((L-pair m1 m2) (up t (up a b) (up va vb)))
    (+ (* 1/2 m1 (square va)) (* 1/2 m2 (square vb)) (* 'k (dot-product a b))))
  (check-identity ((Lagrangian->Hamiltonian (L-pair 'm1 'm2))
                   (up 't (up (up 'x 'y) (up 'z 'w)) (down (down 'a 'b) (down 'c 'd))))
                  (- (+ (/ (+ (square 'a) (square 'b)) (* 2 'm1))
                        (/ (+ (square 'c) (square 'd)) (* 2 'm2)))
                     (* 'k (+ (* 'x 'z) (* 'y 'w))))))

(test-case "an error of the user's own reaches the user"
  (define (L s) (error "my own"))
  (check-message "my own" ((Lagrangian->Hamiltonian L) (up 't 'q 'p)) exn:fail?))
