#lang racket/base
;; Equilibria and their stability: by formulas, by numbers, as verdicts.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt" "../support/systems.rkt")

(define line (up 't 'theta 'thetadot))
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))

;; A bead on a ring that turns about its vertical diameter; theta is from the bottom.
(define ((L-ring m R g omega) (up t theta v))
  (+ (* 1/2 m (square R) (+ (square v) (square (* omega (sin theta)))))
     (* m g R (cos theta))))

(define (L-pendulums m1 m2 l g) (L-double-pendulum m1 m2 l l g))

(define ((L-potential V) (up t q v)) (- (* 1/2 'm (square v)) (V q)))

;; Two bodies at the distance a, with n² a³ = G (M1 + M2), seen from a frame that turns
;; with them; mu is the part of the second body.
(define ((L-three-bodies mu n a) (up t (up x y) (up vx vy)))
  (define (attraction x0 part)
    (/ (* part (square n) (cube a)) (sqrt (+ (square (- x x0)) (square y)))))
  (+ (* 1/2 (+ (square (- vx (* n y))) (square (+ vy (* n x)))))
     (attraction (* -1 mu a) (- 1 mu))
     (attraction (* (- 1 mu) a) mu)))

(define (found L local)
  (for/list ([e (equilibria L local)]) (expression (equilibrium-coordinates e))))
(define (stabilities L local)
  (for/list ([e (equilibria L local)]) (equilibrium-stability L (equilibrium-coordinates e))))
(define (kinds L local) (map stability-kind (stabilities L local)))

(test-case "a bead on a turning ring: at the bottom, at the top, and beside if it turns fast"
  (define all (equilibria (L-ring 'm 'R 'g 'omega) line))
  (check-equal? (found (L-ring 'm 'R 'g 'omega) line)
                '(0
                  :pi
                  (acos (/ g (* R (expt omega 2))))
                  (* -1 (acos (/ g (* R (expt omega 2)))))))
  (check-equal? (for/list ([e all]) (expression (equilibrium-conditions e)))
                '(()
                  ()
                  ((<= -1 (/ g (* R (expt omega 2))) 1))
                  ((<= -1 (/ g (* R (expt omega 2))) 1))))
  (check-equal? (format "~a" (caddr all))
                (string-append "(equilibrium (acos (/ g (* R (expt omega 2)))) "
                               "(<= -1 (/ g (* R (expt omega 2))) 1))"))
  (for ([e all])
    (check-pred proved? (verify-equilibrium (L-ring 'm 'R 'g 'omega) (equilibrium-coordinates e)))))

(test-case "the bifurcation, on both sides"
  (check-equal? (kinds (L-ring 1 1 10 3) line) '(stable unstable))
  (check-equal? (kinds (L-ring 1 1 10 4) line) '(stable stable unstable unstable))
  (assuming ('(> m 0) '(> R 0) '(> g 0))
    (define L (L-ring 'm 'R 'g 'omega))
    (check-equal? (format "~a" (equilibrium-stability L 0))
                  "stable if (> (- g (* R (expt omega 2))) 0), unstable if that is reversed")
    (define tilted (acos (/ 'g (* 'R (square 'omega)))))
    (check-equal? (expression (stability-conditions (equilibrium-stability L tilted)))
                  '((> (- (* R (expt omega 2)) g) 0)))
    (check-equal? (stability-kind (equilibrium-stability L pi)) 'unstable)))

(test-case "two pendulums hang and stand in four ways, one of them stable"
  (define local (up 't (up 'a 'b) (up 'va 'vb)))
  (check-equal? (found (L-pendulums 'm_1 'm_2 'l 'g) local)
                '((up 0 0) (up 0 :pi) (up :pi 0) (up :pi :pi)))
  (assuming ('(> m_1 0) '(> m_2 0) '(> l 0) '(> g 0))
    (check-equal? (kinds (L-pendulums 'm_1 'm_2 'l 'g) local)
                  '(stable unstable unstable unstable))))

(test-case "linear equations are solved together; coordinates without a force may be anything"
  (define (springs q)
    (define-values (x y) (values (ref q 0) (ref q 1)))
    (+ (* 1/2 'k (square (- x 'a))) (* 1/2 'k (square (- y x 'a))) (* -1 'm 'g y)))
  (check-equal? (found (L-potential springs) plane)
                '((up (+ a (/ (* g m) k)) (+ (* 2 a) (/ (* 2 g m) k)))))
  (check-equal? (found (L-potential (lambda (q) (square (ref q 0)))) plane) '((up 0 y)))
  (check-equal? (found (L-potential (lambda (q) (* 'g (ref q 0)))) plane) '())
  (check-equal? (found (L-potential (lambda (q) (* (ref q 0) (ref q 1)))) plane) '((up 0 0))))

(test-case "a double well"
  (define V (lambda (x) (- (* 1/4 'b (expt x 4)) (* 1/2 'a (square x)))))
  (define all (equilibria (L-potential V) (up 't 'x 'v)))
  (check-equal? (map (lambda (e) (expression (equilibrium-coordinates e))) all)
                '(0 (sqrt (/ a b)) (* -1 (sqrt (/ a b)))))
  (check-equal? (expression (equilibrium-conditions (cadr all))) '((> (* a b) 0)))
  (assuming ('(> a 0) '(> b 0))
    (check-equal? (kinds (L-potential V) (up 't 'x 'v)) '(unstable stable stable)))
  (check-equal? (found (L-potential (lambda (x) (+ (cube x) (* 3 x)))) (up 't 'x 'v)) '()))

(test-case "a force moves the equilibrium: a constant torque on a pendulum"
  (define (L (up t theta v)) (+ (* 1/2 (square v)) (* 'k (cos theta))))
  (define all (equilibria L line #:force (lambda (local) 'N)))
  (check-equal? (expression (equilibrium-coordinates (car all))) '(asin (/ N k)))
  (check-pred proved? (verify-equilibrium L (asin (/ 'N 'k)) #:force (lambda (local) 'N)))
  (check-pred refuted? (verify-equilibrium L 0 #:force (lambda (local) 'N))))

(test-case "verdicts: a right proposal, and a plausible wrong one with its condition"
  (define L (L-ring 'm 'R 'g 'omega))
  (check-pred proved? (verify-equilibrium L pi))
  (check-pred proved?
              (verify-equilibrium (+ (compose square velocity) (compose cos coordinate)) pi))
  (define v (verify-equilibrium L (acos (/ 'c (square 'omega)))))
  (check-pred refuted? v)
  (check-equal? (map expression (verdict-conditions v)) '((= g (* R c))))
  (define (driven (up t x v)) (- (* 1/2 (square v)) (* x (cos t))))
  (check-pred refuted? (verify-equilibrium driven 0)))

(test-case "numbers: one near a start is the one the formula gives"
  (check-= (find-equilibrium (L-ring 1 1 10 4) 1.0) (acos 10/16) 1e-12)
  (define q (find-equilibrium (L-pendulums 1 2 3 4) (up 0.1 3.0)))
  (check-= (ref q 0) 0 1e-12)
  (check-= (ref q 1) pi 1e-12))

(test-case "three bodies: the triangle is an equilibrium for all masses, stable below Routh's ratio"
  (define L (L-three-bodies 'mu 'n 'a))
  (define L4 (up (* 'a (- 1/2 'mu)) (sqrt (- (square 'a) (square (* 1/2 'a))))))
  (assuming ('(> a 0) '(> n 0) '(> mu 0) '(> (- 1 mu) 0))
    (check-pred proved? (verify-equilibrium L L4))
    (define s (equilibrium-stability L L4))
    (check-eq? (stability-kind s) 'linearly-stable)
    (check-equal? (expression (stability-conditions s))
                  '((> (+ 1 (* 27 (expt mu 2)) (* -27 mu)) 0))))
  (define (at mu)
    (stability-kind (equilibrium-stability (L-three-bodies mu 1 1) (up (- 1/2 mu) (/ (sqrt 3) 2)))))
  (check-equal? (map at '(1/100 38/1000 39/1000 1/10))
                '(linearly-stable linearly-stable unstable unstable)))

(test-case "between the two bodies no third one stays"
  (define L (L-three-bodies 1/100 1 1))
  (define L1 (find-equilibrium L (up 0.8 0.0)))
  (check-= (ref L1 0) 0.84807871297609 1e-10)
  (check-eq? (stability-kind (equilibrium-stability L L1)) 'unstable))

(test-case "three coordinates in a turning frame, by numbers"
  (define ((L-top-of-hill k Omega) (up t (up x y z) (up vx vy vz)))
    (+ (* 1/2 (+ (square (- vx (* Omega y))) (square (+ vy (* Omega x))) (square vz)))
       (* 1/2 k (+ (square x) (* 2 (square y)))) (* -1 (square z))))
  (define (kind k Omega)
    (stability-kind (equilibrium-stability (L-top-of-hill k Omega) (up 0.0 0.0 0.0))))
  (check-eq? (kind -1.0 0.0) 'stable)
  (check-eq? (kind 1.0 0.1) 'unstable)
  (check-eq? (kind -4.0 3.0) 'linearly-stable))

(test-case "where second derivatives vanish, they do not tell"
  (define s (equilibrium-stability (L-potential (lambda (x) (expt x 4))) 0))
  (check-eq? (stability-kind s) 'undecided)
  (check-equal? (format "~a" s) "undecided: second derivatives do not tell"))

(test-case "an equilibrium at all times, of a force that vanishes at one of them"
  (define ((L V) s) (- (* 1/2 (square (velocity s))) (V (time s) (coordinate s))))
  (check-= (find-equilibrium (L (lambda (t x) (* 1/2 t x x))) 0.7) 0 1e-12)
  (check-= (find-equilibrium (L (lambda (t x) (/ (square (- x 1)) (* 2 t)))) 0.7) 1 1e-12)
  (check-exn #rx"^find-equilibrium: the force on the system at rest changes in time"
             (lambda () (find-equilibrium (L (lambda (t x) (* 1/2 (square (- x t))))) 0.7))))

(test-case "no formula, and a force that changes in time"
  (check-exn
   #rx"^equilibria: no formula was found for the zeros of .*\n  find-equilibrium finds one near"
   (lambda () (equilibria (L-potential (lambda (x) (+ (exp x) (* x (sin x))))) (up 't 'x 'v))))
  (define (pulled (up t x v)) (- (* 1/2 (square v)) (* x (exp t))))
  (check-exn
   #rx"^equilibria: the force on the system at rest changes in time\n  residual: [(]exp t[)]$"
   (lambda () (equilibria pulled (up 't 'x 'v)))))

(says
 [(verify-equilibrium (L-ring 1 1 1 1) '(1 2))
  "verify-equilibrium: expected coordinates, a scalar or an up tuple of scalars\n"
  "  given: (1 2), a list\n  a list is not a tuple; use (up x y ...)"]
 [(equilibrium-stability (L-potential square) 'h)
  "equilibrium-stability: these coordinates are not an equilibrium\n"
  "  coordinates: h\n  residual: (* 2 h)"])

;; ---------------------------------------------------------------------------
;; All of a turn, and powers

(define ((in-potential V) (up t x v)) (- (* 1/2 (square v)) (V x)))
(define (places V) (found (in-potential V) (up 't 'x 'v)))

(test-case "all equilibria of a turn, whatever the period"
  (check-equal? (places (lambda (x) (cos (* 2 x)))) '(0 (* 1/2 :pi) :pi (* -1/2 :pi)))
  (check-equal? (places (lambda (x) (square (sin x)))) '((* 1/2 :pi) (* -1/2 :pi) 0 :pi))
  (check-equal? (length (places (lambda (x) (cos (* 3 x))))) 6)
  (check-equal? (length (places (lambda (x) (sin (- (* 5 x) 'a))))) 10))

(test-case "A cos u + B sin u + C"
  (define (V x) (+ (* 3 (sin x)) (* -4 (cos x)) (* 2 x)))
  (define all (equilibria (in-potential V) (up 't 'x 'v)))
  (check-equal? (length all) 2)
  (for ([e all])
    (define x (exact->inexact (equilibrium-coordinates e)))
    (check-= ((D V) x) 0.0 1e-14))
  (define (V-symbolic x) (+ (* 'a (sin x)) (* 'b (cos x)) (* 'c x)))
  (define symbolic (equilibria (in-potential V-symbolic) (up 't 'x 'v)))
  (check-equal? (map (lambda (e) (length (equilibrium-conditions e))) symbolic) '(1 1))
  (for* ([e symbolic] [a '(1.0 -2.0)] [b '(0.5 -3.0)])
    (define x (substitute (substitute (substitute (equilibrium-coordinates e) 'a a) 'b b) 'c 0.7))
    (check-= (+ (* a (cos x)) (* -1 b (sin x)) 0.7) 0.0 1e-13))
  (check-equal? (places (lambda (x) (+ (sin x) (cos x) (* 2 x)))) '()))

(test-case "powers, and the potential of Lennard-Jones"
  (check-equal? (places (lambda (x) (- (expt x 5) (* 5 x)))) '(1 -1))
  (check-equal? (places (lambda (x) (+ (expt x 4) (* 4 x)))) '(-1))
  (check-equal? (places (lambda (x) (+ (expt x 6) (* 6 x)))) '(-1))
  (check-equal? (places (lambda (x) (+ (expt x 5) (* 5 x)))) '())
  (check-equal? (places (lambda (r) (* 4 'e (- (expt (/ 's r) 12) (expt (/ 's r) 6)))))
                '((* s (expt 2 1/6)) (* -1 s (expt 2 1/6)))))

(test-case "potentials of exponentials: Morse's, Gauss's, hyperbolic ones"
  (define ((L V) (up t x v)) (- (* 1/2 'm (square v)) (V x)))
  (define (rest V) (map equilibrium-coordinates (equilibria (L V) (up 't 'x 'v))))
  (check-equal? (rest (lambda (x) (exp (* -1 (square x))))) '(0))
  (check-equal? (rest (lambda (x) (* x (exp (* -1 x))))) '(1))
  (check-equal? (rest cosh) '(0))
  (check-equal? (rest (lambda (x) (/ 1 (cosh x)))) '(0))
  (check-equal? (rest exp) '())
  (check-equal? (rest (lambda (x) (- (exp x) x))) '(0))
  (define Morse (rest (lambda (x) (square (- 1 (exp (* -1 'a (- x 'r))))))))
  (check-equal? (length Morse) 1)
  (check-pred proved? (prove-zero (- (car Morse) 'r)))
  (define pair (rest (lambda (x) (- (sinh x) (* 2 x)))))
  (check-equal? (length pair) 2)
  (for ([x pair]) (check-true (proved? (verify-equal (cosh x) 2)))))
