#lang racket/base
;; Signs that tell a Hamiltonian from a Lagrangian where either may be asked about, questions that
;; a Hamiltonian answers as a Lagrangian does, and others.

(require mechanics
         mechanics/book
         (only-in mechanics/hamiltonian/classify-system Hamiltonian-told?)
         "../support/checks.rkt" "../support/messages.rkt" "../support/session.rkt")

(define ((H-harmonic m k) s)
  (+ (/ (square (momentum s)) (* 2 m)) (* 1/2 k (square (coordinate s)))))
(define ((H-central m U) s)
  (+ (/ (square (momentum s)) (* 2 m)) (U (sqrt (square (coordinate s))))))
;; by the places of its parts, which tells nothing
(define (H-by-place s) (+ (/ (square (ref s 2)) (* 2 'm)) (* 1/2 'k (square (ref s 1)))))

(define line (up 't 'q 'p))
(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))

;; ---------------------------------------------------------------------------
;; Signs of a Hamiltonian

(test-case "one that asks its state for momenta is a Hamiltonian"
  (check-true (Hamiltonian-told? (H-harmonic 'm 'k) 'q))
  (check-true (Hamiltonian-told? (H-harmonic 'm 'k) (up 'x 'y)))
  (check-true (Hamiltonian-told? (+ (H-harmonic 'm 'k) (lambda (s) (coordinate s))) 'q))
  (check-true (Hamiltonian-told? (lambda (s) (if (< (momentum s) 0) 1 2)) 'q))
  (check-false (Hamiltonian-told? (L-harmonic 'm 'k) 'q))
  (check-false (Hamiltonian-told? (L-harmonic 'm 'k) (up 'x 'y)))
  (check-false (Hamiltonian-told? 3 'q)))

(test-case "of one by places nothing tells, but that it refuses velocities"
  (check-false (Hamiltonian-told? H-by-place 'q))
  (check-true (Hamiltonian-told? (make-Hamiltonian H-by-place) 'q))
  (define (by-product s) (sqrt (* (ref s 1) (ref s 2))))
  (check-true (Hamiltonian-told? (lambda (s) (/ 1 (+ 1 (exp (by-product s))))) (up 'x 'y))
              "x p is a number, x v is none that has a root"))

(test-case "literal functions tell by their signatures, also of one coordinate"
  (for ([n (in-range 1 4)])
    (define q (ref (literal-Hamiltonian-state n) 1))
    (check-true (Hamiltonian-told? (literal-function 'H (Hamiltonian n)) q))
    (check-false (Hamiltonian-told? (literal-function 'L (Lagrangian n)) q)))
  (define H (literal-function 'H (Hamiltonian 1)))
  (check-pred refuted? (verify-conserved H H line))
  (check-identity (verdict-residual (verify-conserved H H line)) (((partial 0) H) line)))

(test-case "the Lagrangian of a Hamiltonian is none, though it asks for momenta within"
  (check-false (Hamiltonian-told? (Hamiltonian->Lagrangian (H-harmonic 1 'k)) 'q))
  (check-false (Hamiltonian-told? (Hamiltonian->Lagrangian (H-harmonic 'm 'k)) (up 'x 'y))))

(test-case "so one coordinate needs no declaration"
  (define H (H-harmonic 'm 'k))
  (check-pred proved? (verify-conserved H H line))
  (check-identity ((rate-of-change H momentum) line) (* -1 'k 'q))
  (check-pred proved? (verify-equilibrium H 0))
  (check-equal? (normal-modes H 0) (normal-modes (L-harmonic 'm 'k) 0))
  (check-identity (mass-matrix H 0) 'm)
  (check-identity (stiffness-matrix H 0) 'k)
  (check-equal? (format "~a" (equilibrium-stability H 0))
                (format "~a" (equilibrium-stability (L-harmonic 'm 'k) 0)))
  (check-pred proved? (verify-solution H (lambda (t) (* 'A (cos (* (sqrt (/ 'k 'm)) t)))))))

;; ---------------------------------------------------------------------------
;; Several coordinates

(test-case "small oscillations, equilibria and stability in the plane"
  (define H (H-harmonic 2. 8.))
  (for ([w (small-oscillation-frequencies H (up 0 0))]) (check-= w 2 1e-14))
  (check-equal? (map equilibrium-coordinates (equilibria (H-harmonic 'm 'k) plane))
                (list (up 0 0)))
  (check-= (ref (find-equilibrium H (up 0.3 0.2)) 0) 0 1e-12)
  (check-eq? (stability-kind (equilibrium-stability H (up 0 0))) 'stable))

(test-case "a charge in a magnetic field rests with momenta that are not 0"
  (define ((H-magnetic m B k) s)
    (define-values (x y p_x p_y)
      (values (ref s 1 0) (ref s 1 1) (ref (momentum s) 0) (ref (momentum s) 1)))
    (+ (/ (+ (square (+ p_x (* B y))) (square p_y)) (* 2 m))
       (* 1/2 k (+ (square (- x 1)) (square (- y 2))))))
  (define H (H-magnetic 1 3 4))
  (check-equal? (map equilibrium-coordinates (equilibria H plane)) (list (up 1 2)))
  (check-equal? (gyroscopic-matrix H (up 1 2)) (matrix-by-rows '(0 -3) '(3 0)))
  (check-equal? (small-oscillation-frequencies H (up 1 2)) '(1 4)))

(test-case "Hamiltonians of the plane are compared at a state of momenta"
  (define V (literal-function 'V (-> (X Real Real) Real)))
  ;; p − ∂f in place of p, with f = x² y
  (define (H-other s)
    (define-values (x y) (values (ref s 1 0) (ref s 1 1)))
    ((H-rectangular 'm V)
     (up (time s) (coordinate s) (- (momentum s) (down (* 2 x y) (square x))))))
  (define e (compare-Lagrangians (H-rectangular 'm V) H-other plane))
  (check-eq? (equivalence-kind e) 'total-derivative)
  (check-identity (equivalence-gauge e) (* (square 'x) 'y)))

;; ---------------------------------------------------------------------------
;; Ignorable coordinates

(define polar (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
(define ((H-polar m U) s)
  (+ (/ (+ (square (ref s 2 0)) (square (/ (ref s 2 1) (ref s 1 0)))) (* 2 m))
     (U (ref s 1 0))))

(test-case "ignorable coordinates, and the momenta that belong to them"
  (define H (H-polar 'm (literal-function 'U)))
  (check-equal? (ignorable-coordinates H polar) '(phi))
  (check-equal? (conserved-momenta H polar) (list (up 'phi 'p_phi)))
  (check-pred proved? (verify-ignorable H 'phi polar))
  (check-pred refuted? (verify-ignorable H 'r polar))
  (check-identity (verdict-residual (verify-ignorable H 0 polar)) (((partial 1 0) H) polar)))

(test-case "the top, from its Lagrangian: the same ones"
  (define H (Lagrangian->Hamiltonian (L-axisymmetric-top 'A 'C 'gMR)))
  (define state (up 't (up 'theta 'phi 'psi) (down 'p_theta 'p_phi 'p_psi)))
  (check-equal? (ignorable-coordinates H state) '(phi psi))
  (check-equal? (conserved-momenta H state) (list (up 'phi 'p_phi) (up 'psi 'p_psi))))

(test-case "of one coordinate, and under a condition"
  (check-equal? (ignorable-coordinates (lambda (s) (square (momentum s))) line) '(q))
  (define v (verify-ignorable (H-harmonic 'm 'k) 'q line))
  (check-pred refuted? v)
  (check-equal? (map expression (verdict-conditions v)) '((= k 0)))
  (check-pred proved? (verify-again v)))

;; ---------------------------------------------------------------------------
;; Forces outside

(define ((friction gamma) s) (* -1 gamma (momentum s)))

(test-case "a force adds to the rate of the momenta"
  (define f (Hamiltonian->state-derivative (H-harmonic 'm 'k) #:force (friction 'gamma)))
  (check-identity (f line) (up 1 (/ 'p 'm) (- (* -1 'k 'q) (* 'gamma 'p))))
  (check-identity (f plane) (up 1 (up (/ 'p_x 'm) (/ 'p_y 'm))
                                (down (- (* -1 'k 'x) (* 'gamma 'p_x))
                                      (- (* -1 'k 'y) (* 'gamma 'p_y)))))
  (check-identity ((phase-space-divergence f) plane) (* -2 'gamma)))

(test-case "of a Hamiltonian that was made of a Lagrangian, too"
  (define H (Lagrangian->Hamiltonian (L-harmonic 'm 'k)))
  (check-identity ((Hamiltonian->state-derivative H #:force (friction 'c)) line)
                  ((Hamiltonian->state-derivative (H-harmonic 'm 'k) #:force (friction 'c)) line)))

(test-case "a damped motion, in both ways"
  (define omega (sqrt (- (/ 'k 'm) (square (/ 'c 2)))))
  (define (q t) (* (exp (* -1/2 'c t)) (cos (* omega t))))
  (define (p t) (* 'm ((D q) t)))
  (define H (H-harmonic 'm 'k))
  (check-pred proved? (verify-Hamiltonian-solution H q p #:force (friction 'c)))
  (check-pred refuted? (verify-Hamiltonian-solution H q p))
  (check-pred proved? (verify-solution H q #:force (friction 'c)))
  (check-identity (((Hamilton-equations H #:force (friction 'c)) q p) 't) (up 0 0 0)))

(test-case "what friction takes from the energy; a central drive keeps the angular momentum"
  (define H (H-harmonic 'm 'k))
  (check-identity ((rate-of-change H H #:force (friction 'c)) line)
                  (/ (* -1 'c (square 'p)) 'm))
  (check-pred refuted? (verify-conserved H H line #:force (friction 'c)))
  (define (L_z s) (- (* (ref s 1 0) (ref s 2 1)) (* (ref s 1 1) (ref s 2 0))))
  (define (drive s) (* (sin (time s)) (down (ref s 1 0) (ref s 1 1))))
  (check-pred proved? (verify-conserved (H-central 'm (literal-function 'U)) L_z plane
                                        #:force drive)))

(test-case "a constant force moves the equilibrium"
  (check-equal? (map equilibrium-coordinates
                     (equilibria (H-harmonic 'm 'k) (up 't 'q 'p) #:force (lambda (s) 'F)))
                (list (/ 'F 'k)))
  (check-= (find-equilibrium (H-harmonic 1. 2.) 0.3 #:force (lambda (s) 1.)) 0.5 1e-12)
  (check-pred proved? (verify-equilibrium (H-harmonic 'm 'k) (/ 'F 'k) #:force (lambda (s) 'F))))

;; ---------------------------------------------------------------------------
;; Refusals

(says
 [(verify-conserved H-by-place H-by-place line)
  "verify-conserved: with one coordinate nothing tells a Hamiltonian from a Lagrangian, "
  "and the third part of the state is named like a momentum\n"
  "  given: H-by-place at (up t q p)\n"
  "  a Hamiltonian is made known by (make-Hamiltonian H-by-place)\n"
  "  of a Lagrangian, give the velocity another name"]
 [(ignorable-coordinates H-by-place (up 't 'theta 'p_theta))
  "ignorable-coordinates: with one coordinate nothing tells a Hamiltonian from a Lagrangian, "
  "and the third part of the state is named like a momentum\n"
  "  given: H-by-place at (up t theta p_theta)\n"
  "  a Hamiltonian is made known by (make-Hamiltonian H-by-place)\n"
  "  of a Lagrangian, give the velocity another name"]
 [(Lagrangian->state-derivative (make-Hamiltonian H-by-place))
  "Lagrangian->state-derivative: expected a Lagrangian; this is known to be a Hamiltonian: "
  "H-by-place\n  the rates of its states are (Hamiltonian->state-derivative H)"]
 [(Lagrangian->energy (make-Hamiltonian H-by-place))
  "Lagrangian->energy: expected a Lagrangian; this is known to be a Hamiltonian: H-by-place\n"
  "  it is the energy itself, as a function of the momenta"]
 [(Lagrangian->Routhian (make-Hamiltonian H-by-place))
  "Lagrangian->Routhian: expected a Lagrangian; this is known to be a Hamiltonian: H-by-place\n"
  "  its Lagrangian is (Hamiltonian->Lagrangian H)"]
 [(gauge-function (make-Hamiltonian H-by-place) (up 't 'q 'v))
  "gauge-function: expected a Lagrangian; this is known to be a Hamiltonian: H-by-place\n"
  "  total time derivatives are functions of the local tuple (up t q v); whether two "
  "Hamiltonians\n  differ by one, (compare-Lagrangians H1 H2 state) tells"]
 [(ignorable-coordinates (H-polar 'm 'U) (up 't (up 'r 'phi) (down 'a 'a)))
  "ignorable-coordinates: the state must be made of symbols, each there once, to stand for any "
  "state\n  given: (up t (up r phi) (down a a))\n  more than once: a"]
 [(Hamiltonian->state-derivative (H-harmonic 1 1) #:force 'F)
  "Hamiltonian->state-derivative: a force outside a Hamiltonian is a function of the state "
  "(up t q p); given the symbol F"])
