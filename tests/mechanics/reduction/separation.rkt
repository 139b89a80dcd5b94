#lang racket/base
;; The Hamilton-Jacobi equation by separation of variables: what is found is proved to solve it,
;; and actions and frequencies are compared to closed forms and to integrations.

(require mechanics
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))
(define polar (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
(define spherical (up 't (up 'r 'theta 'phi) (down 'p_r 'p_theta 'p_phi)))
(define parabolic (up 't (up 'a 'b) (down 'p_a 'p_b)))

;; A particle of mass m in the potential V of rectangular coordinates
(define ((particle m V) s) (+ (/ (square (momentum s)) (* 2 m)) (V (coordinate s))))
(define ((central V) q) (V (sqrt (square q))))
(define (Kepler r) (/ -1 r))

;; Proved to solve the equation; constants that are conserved, and in involution
(define (check-separated s state)
  (check-pred proved? (verify-separation s))
  (define integrals (separation-integrals s))
  (define H (car integrals))
  (for ([f integrals]) (check-pred proved? (verify-conserved H f state)))
  (for* ([f integrals] [g integrals]) (check-identity ((Poisson-bracket f g) state) 0)))

(test-case "Cartesian: each coordinate with an energy of its own"
  (define (V q) (+ (* 1/2 'k (square (ref q 0))) (* 'g (ref q 1))))
  (define s (separate-Hamilton-Jacobi (particle 'm V) plane))
  (check-equal? (separation-constants s) '(E alpha_x))
  (check-identity (separation-momenta s)
                  (down (sqrt (- (* 2 'm 'alpha_x) (* 'k 'm (square 'x))))
                        (sqrt (* 2 'm (- 'E 'alpha_x (* 'g 'y))))))
  (check-separated s plane))

(test-case "polar: any central potential"
  (define H (compose (particle 'm (central (literal-function 'V))) (F->CH p->r)))
  (define s (separate-Hamilton-Jacobi H polar))
  (check-identity (separation-momenta s)
                  (down (sqrt (- (* 2 'm (- 'E ((literal-function 'V) 'r)))
                                 (/ (square 'alpha_phi) (square 'r))))
                        'alpha_phi))
  (check-separated s polar))

(test-case "the name of a constant of separation is none of the Hamiltonian's"
  (define (H s)
    (+ (* 1/2 (+ (square (ref s 2 0)) (square (ref s 2 1))))
       (* 'alpha_x (square (ref s 1 0))) (square (ref s 1 1))))
  (check-equal? (separation-constants
                 (separate-Hamilton-Jacobi H (up 't (up 'x 'y) (down 'p_x 'p_y))))
                '(E alpha_xprime)))

(test-case "spherical: the square of the angular momentum is a constant of separation"
  (define H (compose (particle 'm (central (literal-function 'V))) (F->CH s->r)))
  (define s (separate-Hamilton-Jacobi H spherical))
  (check-equal? (separation-constants s) '(E alpha_phi alpha_theta))
  (check-identity ((caddr (separation-integrals s)) spherical)
                  (+ (square 'p_theta) (/ (square 'p_phi) (square (sin 'theta)))))
  (check-separated s spherical))

(test-case "parabolic: an attracting centre in a uniform field, by the denominator"
  (define (rectangular s)
    (define-values (a b) (values (ref s 1 0) (ref s 1 1)))
    (up (* 1/2 (- (square a) (square b))) (* a b)))
  (define H (compose (particle 1 (lambda (q) (+ ((central Kepler) q) (* 'F (ref q 0)))))
                     (F->CH rectangular)))
  (check-separated (separate-Hamilton-Jacobi H parabolic) parabolic))

(test-case "elliptic: two attracting centres"
  (define (T s)
    (/ (square (momentum s)) (* 2 (- (square (cosh (ref s 1 0))) (square (cos (ref s 1 1)))))))
  (define (V s)
    (define-values (u v) (values (cosh (ref s 1 0)) (cos (ref s 1 1))))
    (- (+ (/ 'k_1 (+ u v)) (/ 'k_2 (- u v)))))
  (define state (up 't (up 'u 'v) (down 'p_u 'p_v)))
  (check-separated (separate-Hamilton-Jacobi (+ T V) state) state))

(test-case "a charge in a magnetic field: linear in a momentum that is conserved"
  (define (H s) (+ (/ (square (ref s 2 0)) (* 2 'm))
                   (/ (square (- (ref s 2 1) (* 'B (ref s 1 0)))) (* 2 'm))))
  (define s (separate-Hamilton-Jacobi H plane))
  (check-equal? (separation-constants s) '(E alpha_y))
  (check-separated s plane))

;; ---------------------------------------------------------------------------
;; The complete integral

(test-case "where integrals have formulas S is one, and solves the equation with the time"
  (define H (particle 'm (lambda (q) (* 'g (ref q 1)))))
  (define S (separation-function (separate-Hamilton-Jacobi H plane)))
  (check-pred proved? (verify-Hamilton-Jacobi H S 't (up 'x 'y)))
  (check-identity (((partial 1) S) 't (up 'x 'y))
                  (separation-momenta (separate-Hamilton-Jacobi H plane))))

(test-case "elsewhere by numbers, from where it is said to begin"
  (define H (particle 1 (lambda (q) (* 1/2 (square q)))))
  (define s (separate-Hamilton-Jacobi H (up 't 'q 'p) #:energy 2))
  (define S (separation-function s #:zero-at 0))
  ;; half of the area of a circle of radius 2 between 0 and 1
  (check-close (S 0 1) (+ (/ (sqrt 3) 2) (* 2 (asin 1/2))) 1e-9))

;; ---------------------------------------------------------------------------
;; Actions and frequencies

(define spherical-Kepler
  (separate-Hamilton-Jacobi (compose (particle 1 (central Kepler)) (F->CH s->r)) spherical))
(define orbit (up 0 (up 1.0 1.3 0.2) (down 0.1 0.4 0.7)))

;; 1/√(−2E) is the sum of the actions, that of θ and φ is L, that of φ its component.
(test-case "Kepler's problem: Delaunay's actions, and the third law"
  (define J (separation-actions spherical-Kepler orbit))
  (define E ((car (separation-integrals spherical-Kepler)) orbit))
  (define L (sqrt ((caddr (separation-integrals spherical-Kepler)) orbit)))
  (check-close (+ (ref J 0) (ref J 1) (ref J 2)) (/ 1 (sqrt (* -2 E))) 1e-11)
  (check-close (+ (ref J 1) (ref J 2)) L 1e-11)
  (define n (expt (* -2 E) 3/2))
  (check-close (separation-frequencies spherical-Kepler orbit) (list n n n) 1e-9))

;; On a line, from an attracting pole at 1; and from one at 0, with 2.622…, half of the lemniscate
;; of unit size.
(test-case "a swing from a pole, whose action has a closed form"
  (define (action V q p)
    (separation-actions (separate-Hamilton-Jacobi (particle 1 V) (up 't 'q 'p)) (up 0 q p)))
  (check-close (action (lambda (q) (/ -1 (- q 1))) 1.5 0.1) (/ 1 (sqrt (- 4 0.01))) 1e-12)
  (check-close (action (lambda (q) (/ -1 (expt (abs q) 4/3))) 1.0 0.5)
               (* (/ 2.622057554292119 pi) (sqrt 2) (expt 0.875 -1/4)) 1e-12)
  (for ([V (list (lambda (q) (/ -1/10 (square q))) (lambda (q) (/ -1 (expt q 4))))])
    (check-regexp-match #rx"^separation-actions: the integral over the swing of q did not converge"
                        (message-of (action V 1.0 0.25) exn:fail:mechanics?))))

(test-case "one coordinate: the action and the frequency of the orbit that is followed"
  (define (quartic q) (+ (* 1/2 (square q)) (* 1/4 (expt q 4))))
  (define H (particle 1 quartic))
  (define s (separate-Hamilton-Jacobi H (up 't 'q 'p)))
  (define state (up 0 0.4 1.1))
  (check-close (separation-actions s state) (action-of-orbit H state) 1e-9)
  (check-close (separation-frequencies s state) (frequency-of-orbit H state) 1e-9))

(test-case "an oscillator in the plane turns twice in its radius"
  (define s (separate-Hamilton-Jacobi
             (compose (particle 2 (lambda (q) (* 4 (square q)))) (F->CH p->r)) polar))
  (check-close (separation-frequencies s (up 0 (up 0.7 0.1) (down 0.3 0.9))) '(4.0 2.0) 1e-10))

;; ---------------------------------------------------------------------------
;; In words, and mistakes

(test-case "what it prints"
  (check-equal? (format "~a" (separate-Hamilton-Jacobi (particle 1 (lambda (q) (ref q 1))) plane))
                (string-append "separated, with the energy E:\n"
                               "  x: p_x = alpha_x\n"
                               "  y: p_y = (sqrt (+ (* 2 E) (* -1 (expt alpha_x 2)) (* -2 y)))")))

(define (coupled s) (+ (square (momentum s)) (* (square (ref s 1 0)) (ref s 1 1))
                       (expt (ref s 1 1) 4)))

(test-case "what does not separate is told, with what is left"
  (check-message
   (string-append "separate-Hamilton-Jacobi: the Hamilton–Jacobi equation of coupled was not found "
                  "to separate in these coordinates\n  what is left, with x and y: "
                  "(+ (expt p_x 2) (* -1 E) (expt p_y 2) (* (expt x 2) y) (expt y 4)) = 0\n"
                  "  other coordinates: (compose H (F->CH F))")
   (separate-Hamilton-Jacobi coupled plane)
   exn:fail:mechanics?))

(define (swinging-up s) (* (time s) (square (momentum s))))

(says
 [(separate-Hamilton-Jacobi swinging-up (up 't 'q 'p))
  "separate-Hamilton-Jacobi: swinging-up depends on the time t; extended-Hamiltonian makes the "
  "time a coordinate\n  its value: (* (expt p 2) t)"]
 [(separate-Hamilton-Jacobi (particle 'E ref) (up 't 'q 'p))
  "separate-Hamilton-Jacobi: the symbol E, for the energy, stands in particle or in the state, "
  "too; #:energy names another"]
 [(separate-Hamilton-Jacobi (lambda (s) (square (ref s 2 0))) plane)
  "separate-Hamilton-Jacobi: <function> does not depend on the momentum p_y: its coordinate rests, "
  "and separates nothing"]
 [(separation-actions spherical-Kepler (up 0 1 2))
  "separation-actions: expected a state like (up t (up r theta phi) (down p_r p_theta p_phi)); "
  "given (up 0 1 2)"]
 [(separation-actions (separate-Hamilton-Jacobi (particle 'm square) (up 't 'q 'p)) (up 0 1 2))
  "separation-actions: the parameters of particle are to be numbers; there is m"]
 [(separation-frequencies (separate-Hamilton-Jacobi (particle 1 square) (up 't 'q 'p)) (up 0 0 0))
  "separation-frequencies: the coordinate q rests at 0.0: its frequency is that of a small swing "
  "about it"])

(test-case "a coordinate that runs away has no action"
  (check-message
   "separation-actions: the coordinate q does not turn back: its motion from 1.0 has no action"
   (separation-actions (separate-Hamilton-Jacobi (particle 1 -) (up 't 'q 'p)) (up 0 1 2))
   exn:fail:mechanics?)
  (define (far q) (/ -1 (- q 10000000)))
  (check-message
   (string-append "separation-actions: the coordinate q does not turn back: its motion from "
                  "10000000.0 has no action")
   (separation-actions (separate-Hamilton-Jacobi (particle 1 far) (up 't 'q 'p)) (up 0 1e7 0.5))
   exn:fail:mechanics?))
