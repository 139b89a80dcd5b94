#lang racket/base
;; Leapfrog and its like follow the systems that they are made for, and no others.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define makers (list leapfrog Yoshida-4 Yoshida-6 Yoshida-8))
(define steps '(0.001 0.01 0.02 0.05))

(define-syntax-rule (check-followed derivative state duration tolerance)
  (let ([expected ((state-advancer (lambda () derivative)) state duration 1e-12)])
    (for ([make (cdr makers)] [h (cdr steps)])
      (define s ((state-advancer (lambda () derivative)) state duration 1e-10 #:method (make h)))
      (check-true (< (euclidean-norm (apply up (structure->list* (- s expected)))) tolerance)
                  (format "~a ~a" (make h) s)))))

(define (structure->list* s)
  (if (structure? s) (apply append (map structure->list* (structure->list s))) (list s)))

;; ---------------------------------------------------------------------------
;; Followed

(define ((L-central m) (up t (up x y) (up vx vy)))
  (+ (* 1/2 m (+ (square vx) (square vy))) (/ 1 (sqrt (+ (square x) (square y))))))

(test-case "a local tuple (t, q, v) of one coordinate, and of several"
  (check-followed (Lagrangian->state-derivative
                   (lambda (s) (- (* 1/2 (square (velocity s))) (* 1/4 (expt (coordinate s) 4)))))
                  (up 0 1 0) 3 1e-4)
  (check-followed (Lagrangian->state-derivative (L-central 2)) (up 0 (up 1 0) (up 0 1)) 2 1e-4))

(test-case "a state (t, q, p) with the rates that Hamilton's equations give"
  (define ((H-central m) s)
    (+ (/ (square (ref s 2)) (* 2 m)) (/ -1 (sqrt (square (ref s 1))))))
  (define H (H-central 2))
  (define (hamiltonian-slope s)
    (up 1 (((partial 2) H) s) (- (((partial 1) H) s))))
  (check-followed hamiltonian-slope (up 0 (up 1 0) (down 0 2)) 2 1e-4))

(test-case "states without a time, and flat ones"
  (check-followed (lambda (s) (up (ref s 1) (- (sin (ref s 0))))) (up 1 0) 3 1e-4)
  (check-followed (lambda (s) (up 1 (ref s 3) (ref s 4) (- (ref s 1)) (* -2 (ref s 2))))
                  (up 0 1 2 0 0) 3 1e-3))

(test-case "forces that depend on the time"
  (check-followed (lambda (s) (up 1 (velocity s) (- (cos (* 2 (time s))) (coordinate s))))
                  (up 0 1 0) 3 1e-4))

(test-case "velocities that cancel in the formula, as for a pendulum with a moving pivot"
  (define ((L-driven g ys) (up t θ v))
    (+ (* 1/2 (+ (square v) (square ((D ys) t)) (* 2 v ((D ys) t) (sin θ))))
       (* g (cos θ)) (* -1 g (ys t))))
  (define derivative
    (Lagrangian->state-derivative (L-driven 9.8 (lambda (t) (* 0.1 (cos (* 6 t)))))))
  (check-followed derivative (up 0 1 0) 1 1e-3)
  (check-followed derivative (up 0 0 0) 1 1e-3))

(test-case "a decision by the position"
  (check-followed (lambda (s) (up 1 (velocity s)
                                  (if (< (coordinate s) 0)
                                      (* -4 (coordinate s))
                                      (- (coordinate s)))))
                  (up 0 1 0) 1 1e-4))

;; ---------------------------------------------------------------------------
;; Refused

(define ((damped c) s)
  (up 1 (velocity s) (- (* -1 (coordinate s)) (* c (velocity s)))))
(define (sliding s)
  (up 1 (velocity s) (if (< (velocity s) 0) 0.1 -0.1)))
(define (magnetic s)
  (define v (velocity s))
  (up 1 v (up (ref v 1) (- (ref v 0)))))
(define polar
  (Lagrangian->state-derivative
   (lambda (s)
     (define-values (q v) (values (coordinate s) (velocity s)))
     (* 1/2 (+ (square (ref v 0)) (square (* (ref q 0) (ref v 1))))))))
(define (skew s) (up 1 (+ (ref s 2) (* 0.1 (ref s 1))) (* -1 (ref s 1))))
(define (breathing s) (up 1 (* (exp (time s)) (ref s 2)) (* -1 (ref s 1))))
(define (three s) (up 1 (ref s 2) (ref s 3) (- (ref s 1))))
(define (without-time s) (up (ref s 1) (ref s 2) (- (ref s 0))))

(define (ever-more-damped s)
  (up 1 (velocity s) (- (* -1 (coordinate s)) (* (time s) (velocity s)))))
(define (rushing s) (up 1 (velocity s) (square (velocity s))))

(define (follow f state method) ((state-advancer (lambda () f)) state 1 1e-10 #:method method))

(define velocity-text
  "moves coordinates and velocities in turn; here the rates of the velocities depend on the velocities\n")
(define coordinate-text
  "moves coordinates and velocities in turn; here the rates of the coordinates depend on the time or the coordinates\n")
(define shape-text
  "takes states of a time, some coordinates and as many velocities or momenta\n")
(define (use method) (format "  use ~a, or a method that chooses its own steps" method))

(says
 [(follow (damped 0.1) (up 0 1 0) (leapfrog 0.01))
  "state-advancer: leapfrog " velocity-text (use "(Gauss-Legendre-2 0.01)")]
 [(follow (damped 1e-6) (up 0 1 0) (Yoshida-4 0.01))
  "state-advancer: Yoshida-4 " velocity-text (use "(Gauss-Legendre-4 0.01)")]
 [(follow rushing (up 0 1 0) (leapfrog 0.01))
  "state-advancer: leapfrog " velocity-text (use "(Gauss-Legendre-2 0.01)")]
 [(follow ever-more-damped (up 0 1 0) (leapfrog 0.01))
  "state-advancer: leapfrog " velocity-text (use "(Gauss-Legendre-2 0.01)")]
 [(follow sliding (up 0 1 0.5) (Yoshida-6 0.25))
  "state-advancer: Yoshida-6 " velocity-text (use "(Gauss-Legendre-6 0.25)")]
 [(follow magnetic (up 0 (up 1 0) (up 0 0)) (Yoshida-8 0.25))
  "state-advancer: Yoshida-8 " velocity-text (use "(Gauss-Legendre-6 0.25)")]
 [(evolve-trajectory polar (up 0 (up 1 0) (up 0 1)) 1 #:method (leapfrog 0.01))
  "evolve-trajectory: leapfrog " velocity-text (use "(Gauss-Legendre-2 0.01)")]
 [((evolve (lambda () skew)) (up 0 1 0) void 0.1 1 1e-10 #:method (leapfrog 0.01))
  "evolve: leapfrog " coordinate-text (use "(Gauss-Legendre-2 0.01)")]
 [(follow breathing (up 0 1 0) (leapfrog 0.01))
  "state-advancer: leapfrog " coordinate-text (use "(Gauss-Legendre-2 0.01)")]
 [(follow three (up 0 1 2 3) (leapfrog 0.01))
  "state-advancer: leapfrog " shape-text "  state: (up 0.0 1.0 2.0 3.0)\n"
  (use "(Gauss-Legendre-2 0.01)")]
 [(follow without-time (up 1 2 3) (leapfrog 0.01))
  "state-advancer: leapfrog " shape-text "  state: (up 1.0 2.0 3.0)\n"
  (use "(Gauss-Legendre-2 0.01)")])

(test-case "what is recommended instead follows them"
  (for ([f (list (damped 0.1) skew breathing)])
    (define expected ((state-advancer (lambda () f)) (up 0 1 0) 1 1e-12))
    (check-= (ref (follow f (up 0 1 0) (Gauss-Legendre-6 0.01)) 1) (ref expected 1) 1e-10)))

(test-case "whether a system can be followed is asked once"
  (define calls 0)
  (define (spring s)
    (set! calls (+ 1 calls))
    (up 1 (velocity s) (if (> (coordinate s) 100) 0 (- (coordinate s)))))
  (define advance (state-advancer (lambda () spring)))
  (define (calls-of-a-step)
    (set! calls 0)
    (advance (up 0 1 0) 0.1 1e-10 #:method (leapfrog 0.1))
    calls)
  (calls-of-a-step)
  (check-true (<= (calls-of-a-step) 5)))
