#lang racket/base
;; F->C: against formulas derived by hand, and against what it means on paths.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/value/compose
         mechanics/value/structure
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         mechanics/value/signature
         mechanics/lagrangian/coordinate-transformation
         mechanics/lagrangian/local-tuple
         mechanics/lagrangian/Lagrange-equations
         (only-in mechanics/book L-free-particle)
         (only-in mechanics/scmutils polar->rectangular rectangular->polar
                  spherical->rectangular rectangular->spherical)
         "../support/checks.rkt" "../support/same.rkt" "../support/systems.rkt")

(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(define spherical (up 't (up 'r 'theta 'phi) (up 'rdot 'thetadot 'phidot)))

;; ---------------------------------------------------------------------------
;; By hand

(test-case "polar coordinates: positions and velocities"
  (check-same ((F->C p->r) polar)
              (up 't
                  (up (g:* 'r (g:cos 'phi)) (g:* 'r (g:sin 'phi)))
                  (up (g:- (g:* 'rdot (g:cos 'phi)) (g:* 'r 'phidot (g:sin 'phi)))
                      (g:+ (g:* 'rdot (g:sin 'phi)) (g:* 'r 'phidot (g:cos 'phi)))))))

(test-case "spherical coordinates: positions and velocities"
  (define-values (st ct sp cp)
    (values (g:sin 'theta) (g:cos 'theta) (g:sin 'phi) (g:cos 'phi)))
  (check-same ((F->C s->r) spherical)
              (up 't
                  (up (g:* 'r st cp) (g:* 'r st sp) (g:* 'r ct))
                  (up (g:+ (g:* 'rdot st cp) (g:* 'r 'thetadot ct cp) (g:* -1 'r 'phidot st sp))
                      (g:+ (g:* 'rdot st sp) (g:* 'r 'thetadot ct sp) (g:* 'r 'phidot st cp))
                      (g:- (g:* 'rdot ct) (g:* 'r 'thetadot st))))))

(test-case "kinetic energy of a free particle in polar and spherical coordinates"
  (check-same ((compose (L-free-particle 'm) (F->C p->r)) polar)
              (g:* 1/2 'm (g:+ (g:square 'rdot) (g:square (g:* 'r 'phidot)))))
  (check-same ((compose (L-free-particle 'm) (F->C s->r)) spherical)
              (g:* 1/2 'm (g:+ (g:square 'rdot) (g:square (g:* 'r 'thetadot))
                               (g:square (g:* 'r 'phidot (g:sin 'theta)))))))

(test-case "rotating axes bring the Coriolis and the centrifugal term (SICM 1.6.1)"
  (define ((rotation Omega) local)
    (define t (time local))
    (define q (coordinate local))
    (define angle (g:* Omega t))
    (up (g:- (g:* (ref q 0) (g:cos angle)) (g:* (ref q 1) (g:sin angle)))
        (g:+ (g:* (ref q 0) (g:sin angle)) (g:* (ref q 1) (g:cos angle)))))
  (define L (compose (L-free-particle 'm) (F->C (rotation 'Omega))))
  (define local (up 't (up 'x 'y) (up 'xdot 'ydot)))
  (check-same (L local)
              (g:+ (g:* 1/2 'm (g:+ (g:square 'xdot) (g:square 'ydot)))
                   (g:* 'm 'Omega (g:- (g:* 'x 'ydot) (g:* 'y 'xdot)))
                   (g:* 1/2 'm (g:square 'Omega) (g:+ (g:square 'x) (g:square 'y)))))
  (define x (literal-function 'x))
  (define y (literal-function 'y))
  (define (second f) (((g:expt D 2) f) 't))
  (check-same (((Lagrange-equations L) literal-plane-path) 't)
              (down (g:- (g:* 'm (second x)) (g:* 2 'm 'Omega ((D y) 't))
                         (g:* 'm (g:square 'Omega) (x 't)))
                    (g:- (g:+ (g:* 'm (second y)) (g:* 2 'm 'Omega ((D x) 't)))
                         (g:* 'm (g:square 'Omega) (y 't))))))

(test-case "there and back: inverse transformations compose to the identity"
  (define near (up 0.3 (up 1.2 0.7) (up -0.4 2.1)))
  (check-same ((compose (F->C r->p) (F->C p->r)) near) near)
  (check-same ((compose (F->C p->r) (F->C r->p)) near) near)
  (define near3 (up 0.3 (up 1.2 0.7 -0.9) (up -0.4 2.1 0.5)))
  (check-same ((compose (F->C r->s) (F->C s->r)) near3) near3)
  (check-same ((compose (F->C s->r) (F->C r->s)) near3) near3))

(test-case "the long names are the same transformations"
  (for ([long (list polar->rectangular rectangular->polar
                    spherical->rectangular rectangular->spherical)]
        [short (list p->r r->p s->r r->s)])
    (check-eq? long short)))

(test-case "angles come out in the right quadrant"
  (check-same (r->p (up 0 (up -1.0 -1.0) 0)) (up (sqrt 2.0) (* -3/4 3.141592653589793)))
  (check-same (r->s (up 0 (up 0.0 -2.0 0.0) 0))
              (up 2.0 (/ 3.141592653589793 2) (/ 3.141592653589793 -2))))

;; ---------------------------------------------------------------------------
;; The meaning

;; C ∘ Γ[q'] = Γ[F ∘ Γ[q']], for local tuples of every length.
(define (check-on-path F path n)
  (check-same ((compose (F->C F) (Gamma path n)) 't)
              ((Gamma (compose F (Gamma path)) n) 't)))

(test-case "F->C of the local tuple of a path is the local tuple of the transformed path"
  (define rphi (up (literal-function 'r) (literal-function 'phi)))
  (define f (literal-function 'f (-> (X Real (UP Real Real)) (UP Real Real))))
  (for ([n (in-range 3 6)])
    (check-on-path p->r rphi n)
    (check-on-path (lambda (local) (f (time local) (coordinate local))) rphi n)
    (check-on-path (lambda (local) (g:* (time local) (g:sin (coordinate local))))
                   (literal-function 'q) n)))

(test-case "transformations in turn are the transformation of the functions in turn"
  (define f (literal-function 'f (-> (X Real (UP Real Real)) (UP Real Real))))
  (define (F local) (f (time local) (coordinate local)))
  (define parts (list (up 'r 'phi) (up 'rdot 'phidot) (up 'rddot 'phiddot)))
  (for ([local (list (apply up 't (list (car parts) (cadr parts))) (apply up 't parts))])
    (check-same ((compose (F->C F) (F->C p->r)) local)
                ((F->C (compose F (F->C p->r))) local))))

(test-case "acceleration in polar coordinates, from a local tuple of four"
  (define C (F->C p->r))
  (define local (up 't (up 'r 'phi) (up 'rdot 'phidot) (up 'rddot 'phiddot)))
  (define a (acceleration (C local)))
  (define c (g:cos 'phi))
  (define s (g:sin 'phi))
  ;; radial and transverse components
  (check-same (g:+ (g:* c (ref a 0)) (g:* s (ref a 1)))
              (g:- 'rddot (g:* 'r (g:square 'phidot))))
  (check-same (g:- (g:* c (ref a 1)) (g:* s (ref a 0)))
              (g:+ (g:* 'r 'phiddot) (g:* 2 'rdot 'phidot))))

(test-case "a transformation with derivatives of its own differentiates like any function"
  (define energy (compose (L-free-particle 'm) (F->C p->r)))
  (check-same (((partial 2) energy) polar) (down (g:* 'm 'rdot) (g:* 'm (g:square 'r) 'phidot)))
  (check-same (((partial 1) energy) polar) (down (g:* 'm 'r (g:square 'phidot)) 0)))

(test-case "one coordinate may be a scalar"
  (check-same ((F->C (lambda (local) (g:exp (coordinate local)))) (up 't 'q 'v))
              (up 't (g:exp 'q) (g:* 'v (g:exp 'q)))))

;; ---------------------------------------------------------------------------
;; Osculating paths and Γ̄

(test-case "the osculating path has the derivatives of the local tuple at its time"
  (define local (up 't 'q 'v 'a 'j))
  (define path (osculating-path local))
  (for ([part '(q v a j 0)] [k (in-naturals)])
    (check-same (((g:expt D k) path) 't) part))
  (check-same ((osculating-path (up 't 'q)) 's) 'q)
  (check-same ((Gamma (osculating-path (up 't (up 'x 'y) (up 'vx 'vy)))) 't)
              (up 't (up 'x 'y) (up 'vx 'vy))))

(test-case "Γ̄ makes a function of local tuples of a function of paths"
  (define F (literal-function 'F (-> (UP Real Real Real) Real)))
  (check-same ((Gamma-bar (lambda (q) (compose F (Gamma q)))) (up 't 'q 'v)) (F (up 't 'q 'v)))
  (check-same ((Gamma-bar (lambda (q) (D q))) (up 't 'q 'v)) 'v))

;; ---------------------------------------------------------------------------
;; Errors

(test-case "what F->C cannot transform is named"
  (define ((pendulum l pivot) local) (up l pivot))
  (check-exn
   #rx"^F->C: a coordinate transformation takes one argument, the local tuple, but pendulum takes 2 arguments.\n  If it takes parameters first, supply them: [(]F->C [(]pendulum [.][.][.][)][)]$"
   (lambda () (F->C pendulum)))
  (check-exn
   #rx"^F->C: expected a coordinate transformation: a function of the local tuple\n  given: the number 3"
   (lambda () (F->C 3)))
  (check-exn
   #rx"^F->C: expected a local tuple [(]up t q v [.][.][.][)]; given [(]up t q[)], an up tuple of 2$"
   (lambda () ((F->C p->r) (up 't 'q))))
  (check-exn #rx"^F->C: expected a local tuple [(]up t q v [.][.][.][)]; given the symbol t$"
             (lambda () ((F->C p->r) 't)))
  (check-exn
   #rx"^p->r: expected a local tuple with 2 coordinates; given [(]up t r v[)], an up tuple of 3$"
   (lambda () ((F->C p->r) (up 't 'r 'v))))
  (check-exn #rx"^s->r: expected a local tuple with 3 coordinates" (lambda () (s->r polar))))

(test-case "a transformation prints as what was typed"
  (check-equal? (format "~a" (F->C p->r)) "(F->C p->r)")
  (check-equal? (format "~a" (compose (L-free-particle 'm) (F->C p->r)))
                "(compose L-free-particle (F->C p->r))"))
