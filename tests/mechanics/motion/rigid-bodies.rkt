#lang racket/base
;; Rigid bodies in Euler angles, followed in time: SICM 2.8.1 and 2.10, in numbers.

(require mechanics
         "../support/checks.rkt" "../support/close.rkt")

;; Angular velocity along the principal axes (2.7).
(define (body-omega s)
  (match-define (up _ (up theta phi psi) (up vtheta vphi vpsi)) s)
  (up (+ (* vphi (sin theta) (sin psi)) (* vtheta (cos psi)))
      (- (* vphi (sin theta) (cos psi)) (* vtheta (sin psi)))
      (+ (* vphi (cos theta)) vpsi)))

(define ((T-body A B C) s)
  (define w (body-omega s))
  (* 1/2 (+ (* A (square (ref w 0))) (* B (square (ref w 1))) (* C (square (ref w 2))))))

;; ---------------------------------------------------------------------------
;; The free body

(define-values (A B C) (values 1.0 (sqrt 2.0) 2.0))
(define start (up 0 (up 1 0 0) (up .1 .1 .1)))

;; Angular momentum along axes fixed in space: turned by psi about z, by theta about x
;; and by phi about z.
(define (angular-momentum s)
  (match-define (up _ (up theta phi psi) _) s)
  (define w (body-omega s))
  ((compose (Rz phi) (Rx theta) (Rz psi))
   (up (* A (ref w 0)) (* B (ref w 1)) (* C (ref w 2)))))

(define (momenta s) (structure->list (angular-momentum s)))

(define energy (T-body A B C))

(define motion
  (evolve-trajectory (Lagrangian->state-derivative (T-body A B C)) start 100 #:tolerance 1e-14))

(test-case "energy and angular momentum at the start"
  (check-= (energy start) .03373214709101889 1e-16)
  (check-close (momenta start) '(.1 -.1949269019817557 .2665824806467499) 1e-15))

(define (scalars s) (append (structure->list (ref s 1)) (structure->list (ref s 2))))

(test-case "angles, rates and angular velocity after 10 and 100"
  (check-close (structure->list (coordinate (motion 10)))
               '(.8936249077256155 1.28849748034278 .9354419439400308) 1e-12)
  (check-close (scalars (motion 100))
               '(.6319896958326486 1.361027154088125 17.43790048473838
                 -.1234371619718829 .09016109524795829 .07567921658610047)
               1e-11)
  (check-close (structure->list (body-omega (motion 100)))
               '(-.07215083472579217 -.1134368298947756 .1484260290508362) 1e-11))

(test-case "energy and angular momentum are kept to 1e-11 over 100 s"
  (for ([t (in-range 0 101)])
    (define s (motion t))
    (check-= (/ (energy s) (energy start)) 1 1e-11)
    (check-close (momenta s) (momenta start) 1e-11)))

(test-case "so they are by the book's method, looser by its order"
  (define s
    ((state-advancer (Lagrangian->state-derivative (T-body A B C)))
     start
     100
     1e-12
     #:method 'qcrk4))
  (check-= (/ (energy s) (energy start)) 1 1e-10)
  (check-close (momenta s) (momenta start) 1e-10))

;; ---------------------------------------------------------------------------
;; The axisymmetric top (2.10)

(define ((L-top A C gMR) s)
  (- ((T-body A A C) s) (* gMR (cos (ref s 1 0)))))

(define-values (top-A top-C gMR) (values 6.96e-4 1.32e-4 0.112))
(define L (L-top top-A top-C gMR))
(define momentum ((partial 2) L))
(define top
  (evolve-trajectory (Lagrangian->state-derivative L) (up 0 (up 0.4 0 0) (up 0 -10 200)) 2
                     #:tolerance 1e-14))

(test-case "the top after 1 s"
  (define s (top 1))
  (check-close (structure->list (coordinate s))
               '(.7636717173299069 4.989548088316894 187.388061898977) 1e-9)
  (check-= (ref (momentum s) 0) -.002389367104876363 1e-12))

(test-case "its tilt goes to and fro, where theta-dot passes zero"
  (define turns
    (trajectory-events
     (evolve-trajectory (Lagrangian->state-derivative L) (up 0 (up 0.4 0 0) (up 0 -10 200)) 2
                        #:tolerance 1e-13 #:events (event (lambda (s) (ref s 2 0))))))
  (check-true (> (length turns) 5))
  (for ([o turns] [k (in-naturals)])
    (check-= (ref (occurrence-state o) 1 0) (if (even? k) .809714734259 0.4) 1e-10)))

(test-case "its energy and the momenta of phi and psi are kept"
  (define E (Lagrangian->energy L))
  (for ([t (in-range 0 2 1/10)])
    (define-values (s s0) (values (top t) (top 0)))
    (check-= (/ (E s) (E s0)) 1 1e-12)
    (check-= (ref (momentum s) 1) (ref (momentum s0) 1) 1e-14)
    (check-= (ref (momentum s) 2) (ref (momentum s0) 2) 1e-14)))
