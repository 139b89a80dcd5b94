#lang racket/base
;; The total time derivative and the Euler–Lagrange operator (SICM 1.9).

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/value/compose
         mechanics/value/operator
         mechanics/value/structure
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         mechanics/value/signature
         mechanics/lagrangian/coordinate-transformation
         mechanics/lagrangian/Lagrange-equations
         mechanics/lagrangian/local-tuple
         mechanics/lagrangian/total-derivative
         (only-in mechanics/book L-harmonic)
         (only-in mechanics/scmutils LE Lagrange-equations-operator)
         "../support/checks.rkt" "../support/same.rkt" "../support/systems.rkt")

(define F (literal-function 'F (-> (UP Real Real Real) Real)))
(define G (literal-function 'G (-> (UP Real Real Real) Real)))
(define q (literal-function 'q))
(define local (up 't 'x 'v 'a))

(test-case "D_t F is ∂₀F + ∂₁F v + ∂₂F a"
  (define at (up 't 'x 'v))
  (check-same ((Dt F) local)
              (g:+ (((partial 0) F) at)
                   (g:* (((partial 1) F) at) 'v)
                   (g:* (((partial 2) F) at) 'a))))

(test-case "D_t of time, coordinate and velocity"
  (check-equal? (map (lambda (f) ((Dt f) local)) (list time coordinate velocity)) '(1 v a))
  (check-equal? ((Dt (Dt coordinate)) local) 'a))

(test-case "along a path it is the derivative by time"
  (for ([f (list F (g:* F (g:sin G)) (compose g:exp velocity))])
    (check-same ((compose (Dt f) (Gamma q 4)) 't) ((D (compose f (Gamma q))) 't)))
  (check-same ((compose (Dt (Dt F)) (Gamma q 5)) 't) (((g:expt D 2) (compose F (Gamma q))) 't)))

(test-case "it agrees with the definition by way of an osculating path"
  (check-same ((Dt F) local)
              ((Gamma-bar (lambda (q) (D (compose F (Gamma q))))) local)))

(test-case "it is a derivation"
  (check-same ((Dt (g:+ F (g:* 'c G))) local) (g:+ ((Dt F) local) (g:* 'c ((Dt G) local))))
  (check-same ((Dt (g:* F G)) local)
              (g:+ (g:* ((Dt F) local) (G (up 't 'x 'v))) (g:* (F (up 't 'x 'v)) ((Dt G) local)))))

(test-case "functions of several coordinates, with tuples as values"
  (define local (up 't (up 'x 'y) (up 'vx 'vy) (up 'ax 'ay)))
  (check-same ((Dt (lambda (l) (g:* (time l) (coordinate l)))) local)
              (up (g:+ 'x (g:* 't 'vx)) (g:+ 'y (g:* 't 'vy))))
  (check-same ((Dt (g:square velocity)) local) (g:* 2 (g:+ (g:* 'vx 'ax) (g:* 'vy 'ay)))))

(test-case "the Euler-Lagrange operator of the oscillator is m a + k x (p. 98)"
  (check-same ((Euler-Lagrange-operator (L-harmonic 'm 'k)) local) (g:+ (g:* 'm 'a) (g:* 'k 'x))))

(test-case "on the local tuple of a path it is the residual of Lagrange's equations"
  (for ([L (list (L-harmonic 'm 'k) (literal-function 'L (Lagrangian)))])
    (check-same ((compose (Euler-Lagrange-operator L) (Gamma q 4)) 't)
                (((Lagrange-equations L) q) 't)))
  (define L (L-orbital 'm 'mu))
  (check-same ((compose (LE L) (Gamma literal-plane-path 4)) 't)
              (((Lagrange-equations L) literal-plane-path) 't))
  (check-eq? LE Lagrange-equations-operator))

(test-case "a total time derivative has the Euler-Lagrange operator 0"
  (define f (literal-function 'f (-> (UP Real Real) Real)))
  (check-same ((Euler-Lagrange-operator (Dt f)) local) 0))

(test-case "of a Lagrangian with accelerations it is the residual of the same order"
  (define (L local)
    (g:- (g:* -1/2 'm (coordinate local) (acceleration local))
         (g:* 1/2 'k (g:square (coordinate local)))))
  (check-same ((Euler-Lagrange-operator L #:order 2) (up 't 'x 'v 'a 'j 's))
              (g:+ (g:* 'm 'a) (g:* 'k 'x)))
  (define any (literal-function 'L (-> (UP Real Real Real Real) Real)))
  (check-same ((compose (Euler-Lagrange-operator any #:order 2) (Gamma q 6)) 't)
              (((Lagrange-equations any #:order 2) q) 't))
  (check-equal? (format "~a" (Euler-Lagrange-operator any #:order 2))
                "(Euler-Lagrange-operator L #:order 2)"))

(test-case "clipping local tuples"
  (check-equal? ((clip-state 3) local) (up 't 'x 'v))
  (check-equal? (trim-last-argument local) (up 't 'x 'v))
  (check-equal? (trim-last-argument (vector 't 'x 'v)) (up 't 'x))
  (check-exn
   #rx"^clip-state: expected a local tuple of at least 5 components; given [(]up t x v a[)], an up tuple of 4$"
   (lambda () ((clip-state 5) local)))
  (check-exn #rx"^clip-state: expected a length of local tuples"
             (lambda () (clip-state 1)))
  (check-exn #rx"^trim-last-argument: expected a local tuple\n  given: the number 3$"
             (lambda () (trim-last-argument 3))))

(test-case "operators and their images print as what was typed"
  (check-pred operator? Dt)
  (check-equal? (format "~a" (list Dt (Dt F) (g:expt Dt 2))) "(Dt (Dt F) (expt Dt 2))")
  (define (L local) 0)
  (check-equal? (format "~a" (Euler-Lagrange-operator L)) "(Euler-Lagrange-operator L)"))

(test-case "what it cannot take is named"
  (check-exn #rx"^Dt: expected a function of the local tuple\n  given: the number 3"
             (lambda () (Dt 3)))
  (check-exn
   #rx"^Dt: expected a local tuple [(]up t q v [.][.][.][)]; given [(]up t q[)], an up tuple of 2$"
   (lambda () ((Dt F) (up 't 'q))))
  (check-exn
   #rx"^Dt: the parts of the local tuple differ in shape\n  coordinates: [(]up x y[)]\n  another: a$"
   (lambda () ((Dt velocity) (up 't (up 'x 'y) (up 'vx 'vy) 'a))))
  (check-exn
   #rx"^Euler-Lagrange-operator: expected a local tuple [(]up t q v [.][.][.][)] of at least 4 components; given [(]up t q v[)], an up tuple of 3$"
   (lambda () ((Euler-Lagrange-operator F) (up 't 'q 'v))))
  (check-exn #rx"^Euler-Lagrange-operator: .*an order, a positive integer"
             (lambda () (Euler-Lagrange-operator F #:order 0)))
  (check-exn #rx"^Euler-Lagrange-operator: a Lagrangian is a function"
             (lambda () (Euler-Lagrange-operator 3))))
