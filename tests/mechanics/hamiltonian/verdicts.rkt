#lang racket/base
;; Questions that Hamiltonians answer: solutions, conserved quantities, and what is asked of a
;; Lagrangian otherwise.

(require mechanics
         mechanics/book
         mechanics/rackunit
         "../support/checks.rkt" "../support/messages.rkt" "../support/session.rkt")

(define ((H-harmonic m k) s)
  (+ (/ (square (momentum s)) (* 2 m)) (* 1/2 k (square (coordinate s)))))
(define ((H-central m U) s)
  (+ (/ (square (momentum s)) (* 2 m)) (U (sqrt (square (coordinate s))))))

(define line (up 't 'q 'p))
(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))
(define space (up 't (up 'x 'y 'z) (down 'p_x 'p_y 'p_z)))

;; ---------------------------------------------------------------------------
;; Solutions

(define omega (sqrt (/ 'k 'm)))
(define (q t) (* 'A (cos (+ (* omega t) 'phi))))
(define (p t) (* -1 'm omega 'A (sin (+ (* omega t) 'phi))))

(test-case "a motion of the oscillator"
  (check-pred proved? (verify-Hamiltonian-solution (H-harmonic 'm 'k) q p)))

(test-case "with the wrong sign of the momentum it is none"
  (define v (verify-Hamiltonian-solution (H-harmonic 'm 'k) q (lambda (t) (- (p t)))))
  (check-pred refuted? v))

(test-case "a wrong rate is told by its condition"
  (define v (verify-Hamiltonian-solution (H-harmonic 'm 'k)
                                         (lambda (t) (* 'A (cos (* 'w t))))
                                         (lambda (t) (* -1 'm 'w 'A (sin (* 'w t))))))
  (check-pred refuted? v)
  (check-equal? (map expression (verdict-conditions v)) '((= k (* m (expt w 2))))))

(test-case "paths in the plane; rest is remarked on"
  (define (c t) (up (* 'a (cos t)) (* 'b (sin t))))
  (define (d t) (down (* -1 'a (sin t)) (* 'b (cos t))))
  (check-pred proved? (verify-Hamiltonian-solution (H-harmonic 1 1) c d))
  (define rest (verify-Hamiltonian-solution (H-harmonic 1 1) (lambda (t) 0) (lambda (t) 0)))
  (check-pred proved? rest)
  (check-equal? (verdict-remarks rest) '("the path does not depend on the time")))

(test-case "a kink in a path is no motion"
  (check-false (proved? (verify-Hamiltonian-solution (lambda (s) 0) sgn (lambda (t) 0)))))

;; ---------------------------------------------------------------------------
;; Conserved quantities

(define (L_z s)
  (- (* (ref (coordinate s) 0) (ref (momentum s) 1))
     (* (ref (coordinate s) 1) (ref (momentum s) 0))))

(test-case "brackets decide: the angular momentum"
  (define U (literal-function 'U))
  (check-conserved (H-central 'm U) L_z plane)
  (define V (literal-function 'V (-> (X Real Real) Real)))
  (check-pred refuted? (verify-conserved (H-rectangular 'm V) L_z plane)))

(test-case "the Hamiltonian itself, unless it depends on the time"
  (define H (literal-function 'H (-> (UP (UP* Real 2) (DOWN* Real 2)) Real)))
  (define (H-fixed s) (H (up (coordinate s) (momentum s))))
  (check-conserved H-fixed H-fixed plane)
  (define H-moving (literal-function 'H (Hamiltonian 2)))
  (define v (verify-conserved H-moving H-moving plane))
  (check-pred refuted? v)
  (check-identity (verdict-residual v) (((partial 0) H-moving) plane)))

(test-case "a tuple of quantities, and one that depends on the time"
  (define (free s) (/ (square (momentum s)) (* 2 'm)))
  (check-conserved free momentum plane)
  (define (start s) (- (coordinate s) (* (time s) (/ (flip (momentum s)) 'm))))
  (check-conserved free start plane))

(test-case "the vector of Runge and Lenz"
  (define (angular s) (cross-product (coordinate s) (flip (momentum s))))
  (define (runge-lenz s)
    (- (cross-product (flip (momentum s)) (angular s))
       (* 'm 'mu (/ (coordinate s) (sqrt (square (coordinate s)))))))
  (define H (H-central 'm (lambda (r) (/ (- 'mu) r))))
  (check-conserved H runge-lenz space)
  (check-conserved H angular space)
  (check-pred refuted? (verify-conserved (H-central 'm (lambda (r) (/ (- 'mu) (square r))))
                                         runge-lenz space)))

(test-case "angular momenta: their brackets are angular momenta"
  (define (angular s) (cross-product (coordinate s) (flip (momentum s))))
  (define-values (x y z)
    (values (compose (component 0) angular) (compose (component 1) angular)
            (compose (component 2) angular)))
  (check-identity ((Poisson-bracket x y) space) (z space))
  (check-identity ((Poisson-bracket y z) space) (x space))
  (check-identity ((Poisson-bracket angular angular) space)
                  (up (up 0 (z space) (- (y space)))
                      (up (- (z space)) 0 (x space))
                      (up (y space) (- (x space)) 0))))

(test-case "with one coordinate a Hamiltonian is known by how it was made"
  (define H (make-Hamiltonian (H-harmonic 'm 'k)))
  (check-conserved H H line)
  (define L->H (Lagrangian->Hamiltonian (L-harmonic 'm 'k)))
  (check-conserved L->H L->H line)
  ;; taken for a Lagrangian it has another energy
  (define (H-untold s) (+ (/ (square (ref s 2)) (* 2 'm)) (* 1/2 'k (square (ref s 1)))))
  (define untold (verify-conserved H-untold H-untold (up 't 'q 'v)))
  (check-pred refuted? untold)
  (check-equal? (verdict-remarks untold)
                (list (string-append "it was taken for a Lagrangian; with (make-Hamiltonian H) "
                                     "for H it is a Hamiltonian")))
  (check-identity ((rate-of-change H momentum) line) (* -1 'k 'q))
  (check-identity ((rate-of-change L->H coordinate) line) (/ 'p 'm)))

(test-case "a rate of change in phase space"
  (check-identity ((rate-of-change (H-central 'm (literal-function 'U)) coordinate) plane)
                  (up (/ 'p_x 'm) (/ 'p_y 'm))))

(says
 [(verify-conserved (H-harmonic 'm 'k) L_z (up 't (up 'x 'x) (down 'a 'b)))
  "verify-conserved: the state must be made of symbols, each there once, to stand for any state\n"
  "  given: (up t (up x x) (down a b))\n  more than once: x"]
 [(verify-conserved (H-harmonic 'm 'k) L_z (up 't (up 'x 'm) (down 'a 'b)))
  "verify-conserved: the symbol m is a parameter of H-harmonic, and stands in the state, too\n"
  "  state: (up t (up x m) (down a b))\n  give one of them another name"]
 [(verify-conserved (make-Hamiltonian (H-harmonic 'm 'k)) L_z (up 't (up 'x 'y) (up 'vx 'vy)))
  "verify-conserved: "
  "the third part of a Hamiltonian state is the momenta, dual to the coordinates\n"
  "  coordinates: (up x y)\n  in their place: (up vx vy)\n"
  "  momenta are written (down vx vy); velocities belong to a Lagrangian"]
 [(verify-conserved (H-harmonic 'm 'k) L_z plane #:force (lambda (s) (up 0 0)))
  "verify-conserved: the force must be a down tuple of 2, like the momenta; "
  "given (up 0 0), an up tuple of 2"]
 [(verify-conserved (H-harmonic 'm 'k) L_z plane #:force 3)
  "verify-conserved: a force outside a Hamiltonian is a function of the state (up t q p); "
  "given the number 3"]
 [(verify-Hamiltonian-solution (H-harmonic 1 1) 'q sin)
  "verify-Hamiltonian-solution: a path is a function of time, or a tuple of such functions; "
  "given the symbol q\n  (literal-function 'q) makes a path of that name"]
 [(equilibria 3 (up 't 'q 'v))
  "equilibria: a Lagrangian is a function of the local tuple (up t q v); given the number 3"]
 [(verify-equilibrium 3 0)
  "verify-equilibrium: a Lagrangian is a function of the local tuple (up t q v); "
  "given the number 3"]
 [(make-Hamiltonian 3)
  "make-Hamiltonian: a Hamiltonian is a function of the state (up t q p); given the number 3"]
 [(make-Hamiltonian square 3)
  "make-Hamiltonian: expected an energy: a function of the state\n  given: the number 3"])

;; ---------------------------------------------------------------------------
;; Questions as to a Lagrangian

(define H-pendulum (Lagrangian->Hamiltonian (L-pendulum 'g 'm 'l)))

(test-case "a Hamiltonian is asked for what a Lagrangian is"
  (define local (up 't 'theta 'thetadot))
  (check-equal? (map equilibrium-coordinates (equilibria H-pendulum local))
                (map equilibrium-coordinates (equilibria (L-pendulum 'g 'm 'l) local)))
  (check-pred proved? (verify-equilibrium H-pendulum 0))
  (check-equal? (format "~a" (equilibrium-stability H-pendulum 0))
                "stable if (> (* g l m) 0), unstable if that is reversed")
  (check-equal? (normal-modes (make-Hamiltonian (H-harmonic 'm 'k)) 0)
                (normal-modes (L-harmonic 'm 'k) 0))
  (check-= (find-equilibrium (Lagrangian->Hamiltonian (L-pendulum 9.8 1.0 1.0)) 3.0) pi 1e-9)
  (check-pred proved? (verify-solution (make-Hamiltonian (H-harmonic 'm 'k)) q)))

(test-case "two Hamiltonians of which the Lagrangians differ by a total time derivative"
  (define V (literal-function 'V))
  (define (H1 s) (+ (/ (square (momentum s)) 2) (V (coordinate s))))
  (define (H2 s) (+ (/ (square (- (momentum s) (sin (coordinate s)))) 2) (V (coordinate s))))
  (define e (compare-Lagrangians (make-Hamiltonian H1) (make-Hamiltonian H2) (up 't 'q 'v)))
  (check-eq? (equivalence-kind e) 'total-derivative)
  (check-identity (equivalence-gauge e) (- (cos 'q))))
