#lang racket/base
;; SICM 1.9, Abstraction of Path Functions (pp. 91-99).

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/session.rkt")

(define q (literal-function 'q))
(define F (literal-function 'F (-> (UP Real Real Real) Real)))
(define G (literal-function 'G (-> (UP Real Real Real) Real)))
(define H (literal-function 'H))
(define local (up 't 'x 'v 'a))
(define state (up 't 'x 'v))
(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))

(test-case "p. 95: a function of paths becomes one of local tuples"
  (check-identity ((Gamma-bar (lambda (q) (compose F (Gamma q)))) state) (F state))
  (define ((Gamma-bar-typed f-bar) local)
    ((f-bar (osculating-path local)) (time local)))
  (define (rate q) (D (compose F (Gamma q))))
  (check-identity ((Gamma-bar rate) local) ((Gamma-bar-typed rate) local)))

(test-case "p. 95: the osculating path has the local tuple as its own"
  (check-identity ((Gamma (osculating-path local) 4) 't) local)
  (check-identity ((osculating-path (up 't_0 'q 'v 'a)) 't)
                  (+ 'q (* 'v (- 't 't_0)) (* 1/2 'a (square (- 't 't_0))))))

(test-case "p. 96: the general F->C, for local tuples of any length"
  (define (F->C-typed F)
    (define (C local)
      (let ((n (vector-length local)))
        (define (f-bar q-prime)
          (define q (compose F (Gamma q-prime)))
          (Gamma q n))
        ((Gamma-bar f-bar) local)))
    C)
  (for ([parts '(() ((up rddot phiddot)) ((up rddot phiddot) (up rdddot phidddot)))])
    (define long
      (apply up (append (structure->list polar)
                        (for/list ([p parts]) (apply up (cdr p))))))
    (check-identity ((F->C p->r) long) ((F->C-typed p->r) long)))
  (check-identity ((F->C p->r) polar)
                  (up 't
                      (up (* 'r (cos 'phi)) (* 'r (sin 'phi)))
                      (up (- (* 'rdot (cos 'phi)) (* 'r 'phidot (sin 'phi)))
                          (+ (* 'rdot (sin 'phi)) (* 'r 'phidot (cos 'phi)))))))

(test-case "exercise 1.37: velocities transform by the derivative of the coordinates"
  (define (velocity-of q) (D (compose p->r (Gamma q))))
  (check-identity ((Gamma-bar velocity-of) polar) (velocity ((F->C p->r) polar))))

(test-case "p. 97: the total time derivative as the book defines it"
  (define (Dt-typed F)
    (define (DtF state)
      (let ((n (vector-length state)))
        (define (DF-on-path q)
          (D (compose F (Gamma q (- n 1)))))
        ((Gamma-bar DF-on-path) state)))
    DtF)
  (check-identity ((Dt F) local) (((make-operator Dt-typed 'Dt) F) local))
  (check-identity ((Dt coordinate) state) 'v)
  (check-identity ((Dt (Dt coordinate)) local) 'a)
  (check-identity ((Dt F) local)
                  (+ (((partial 0) F) state) (* (((partial 1) F) state) 'v)
                     (* (((partial 2) F) state) 'a))))

(test-case "exercise 1.26: properties of the total time derivative"
  (check-identity ((Dt (+ F G)) local) (+ ((Dt F) local) ((Dt G) local)))
  (check-identity ((Dt (* 'c F)) local) (* 'c ((Dt F) local)))
  (check-identity ((Dt (* F G)) local)
                  (+ (* ((Dt F) local) (G state)) (* (F state) ((Dt G) local))))
  (check-identity ((Dt (compose H F)) local) (* ((D H) (F state)) ((Dt F) local))))

(test-case "p. 98: the Euler-Lagrange operator"
  (check-prints ((Euler-Lagrange-operator (L-harmonic 'm 'k)) local) '(+ (* a m) (* k x)))
  (define (typed L)
    (- (Dt ((partial 2) L)) (compose ((partial 1) L) trim-last-argument)))
  (check-identity ((Euler-Lagrange-operator F) local) ((typed F) local)))

(test-case "p. 98: composed with the local tuple of a path it is the residual"
  (check-identity ((compose (Euler-Lagrange-operator (L-harmonic 'm 'k)) (Gamma q 4)) 't)
                  (((Lagrange-equations (L-harmonic 'm 'k)) q) 't)))

(test-case "exercise 1.38: properties of the operator"
  (define E Euler-Lagrange-operator)
  (define (momentum F) (((partial 2) F) state))
  (check-identity ((E (+ F G)) local) (+ ((E F) local) ((E G) local)))
  (check-identity ((E (* 'c F)) local) (* 'c ((E F) local)))
  (check-identity ((E (* F G)) local)
                  (+ (* ((E F) local) (G state)) (* (F state) ((E G) local))
                     (* ((Dt F) local) (momentum G)) (* (momentum F) ((Dt G) local))))
  (check-identity ((E (compose H G)) local)
                  (+ (* ((Dt (compose (D H) G)) local) (momentum G))
                     (* ((D H) (G state)) ((E G) local)))))

(test-case "exercise 1.38: a total time derivative has no equations"
  (define f (literal-function 'f (-> (UP Real Real) Real)))
  (check-identity ((Euler-Lagrange-operator (Dt f)) local) 0))
