#lang racket/base
;; Claims proved though there is a kink somewhere: where no derivative meets it, where
;; its sign is known, where it is that of a parameter, or a distance.

(require mechanics
         (only-in mechanics/book L-free-particle L-harmonic)
         (only-in "../support/systems.rkt" L-on-a-line)
         "../support/checks.rkt")

(define L-free (L-free-particle 'm))
(define (L-with V) (L-on-a-line 'm V))
(define line (up 't 'x 'v))
(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))

(define (solution? q [L L-free]) (proved? (verify-solution L q)))

(test-case "what has a sign has no kink"
  (check-true (solution? (lambda (t) (* 'a t (sgn (+ 1 (square t)))))))
  (check-true (solution? (lambda (t) (* t (sgn (+ (square t) (* 2 t) 2))))))
  (check-true (solution? (lambda (t) (* t (sgn (+ 2 (cos t)))))))
  (check-true (solution? (lambda (t) (* t (/ (exp t) (exp t))))))
  (check-true (solution? (lambda (t) (log (exp t)))))
  (check-true (solution? (lambda (t) (* t (/ (cosh t) (cosh t)))))))

(test-case "a sign that was declared is told"
  (assuming ('(> t 0))
    (define v (verify-solution L-free abs))
    (check-equal? (format "~a" v) "proved: the residual is zero\n  given: (> t 0)")
    (check-equal? (verdict-kinks v) '()))
  (assuming ('(> x 0))
    (define v (verify-ignorable (L-with sgn) 'x line))
    (check-equal? (format "~a" v) "proved: the residual is zero\n  given: (> x 0)"))
  (assuming ('(> x 3))
    (check-pred undecided? (verify-ignorable (L-with (lambda (x) (sgn (- x 5)))) 'x line))
    (check-pred proved? (verify-ignorable (L-with (lambda (x) (sgn (- x 2)))) 'x line))))

(test-case "a sign that the domain gives costs nothing"
  (define v (verify-ignorable (lambda (local)
                                (define q (coordinate local))
                                (+ (sgn (ref q 0)) (log (ref q 0))
                                   (* -1 (log (ref q 0)))
                                   (sgn (ref q 1)) (sqrt (- (ref q 1) 1))
                                   (* -1 (sqrt (- (ref q 1) 1)))))
                              'x (up 't (up 'x 'y) (up 'vx 'vy))))
  (check-equal? (format "~a" v) "proved: the residual is zero")
  (define (beside-log t) (+ (* t (sgn t)) (* 0 (log t))))
  (check-equal? (format "~s" (verdict-kinks (verify-solution L-free beside-log)))
                "((no-value (log t) (= t 0)))"))

(test-case "a value that vanishes at the edge is no sign for a jump"
  (assuming ('(>= x 0))
    (check-pred undecided? (verify-ignorable (L-with sgn) 'x line))))

(test-case "what is not differentiated has no say"
  (define (friction local) (* -1 'b (sgn (velocity local))))
  (check-pred proved? (verify-solution L-free (lambda (t) 'c) #:force friction))
  (define (L-growing local) (* 1/2 (square (abs 'm)) (square (velocity local))))
  (check-true (solution? (lambda (t) (* (abs 'a) t)) L-growing))
  (define (plane-step local)
    (- (* 1/2 'm (square (velocity local))) (sgn (ref (coordinate local) 0))))
  (define plane (up 't (up 'x 'y) (up 'vx 'vy)))
  (check-equal? (ignorable-coordinates plane-step plane) '(y))
  (check-pred proved? (verify-ignorable plane-step 'y plane))
  (define along (nonholonomic (lambda (t q v) (+ (ref v 2) (* (sgn (ref q 0)) (ref v 0))))))
  (check-pred proved? (Frobenius-test along (up 'x 'y 'z)))
  (define v (verify-solution L-free (literal-function 'x) #:force friction))
  (check-pred refuted? v)
  (check-equal? (verdict-kinks v) '()))

(test-case "a kink that two Lagrangians share is none of their difference"
  (check-pred proved? (verify-equivalent-Lagrangians (L-with abs)
                                                     (L-with (lambda (x) (+ 3 (abs x)))) line)))

(test-case "distances: r is √(x² + y²), at whose zero a potential has no value"
  (define ((L-central U) local)
    (define r (sqrt (square (coordinate local))))
    (- (* 1/2 'm (square (velocity local))) (U r)))
  (define U (literal-function 'U))
  (define (polar->plane local)
    (define q (coordinate local))
    (up (* (ref q 0) (cos (ref q 1))) (* (ref q 0) (sin (ref q 1)))))
  (define L (compose (L-central U) (F->C polar->plane)))
  (check-pred proved? (verify-ignorable L 'phi polar))
  (check-pred proved? (verify-conserved L (Lagrangian->energy L) polar))
  (check-pred proved?
              (verify-conserved (L-central U) (Lagrangian->energy (L-central U))
                                (up 't (up 'x 'y) (up 'vx 'vy))))
  (define (circle t) (up (* 'R (cos (* 'w t))) (* 'R (sin (* 'w t)))))
  (define (Kepler r) (/ (* -1 'm (square 'w) (cube 'R)) r))
  (check-pred proved? (verify-solution (L-central Kepler) circle))
  ;; In one dimension it is a kink.
  (define v (verify-conserved (L-central U) (Lagrangian->energy (L-central U)) line))
  (check-equal? (format "~s" (verdict-kinks v)) "((kink (sqrt (expt x 2)) (= x 0)))"))

(test-case "a straight line in polar coordinates, where the angle has its cut on the other side"
  (define T (lambda (local)
              (define-values (r v) (values (ref (coordinate local) 0) (velocity local)))
              (* 1/2 'm (+ (square (ref v 0)) (square (* r (ref v 1)))))))
  (define (straight t) (up (sqrt (+ (square 'd) (square (* 'v t)))) (atan (* 'v t) 'd)))
  (check-equal? (format "~a" (verify-solution T straight))
                "proved: the residual is zero\n  assuming: (> d 0)")
  (assuming ('(< d 0))
    (check-equal? (format "~s" (verdict-kinks (verify-solution T straight)))
                  "((jump (atan (* t v) d) (= t 0) (< d 0)))")))

(test-case "dissipation functions and constraints are differentiated, too"
  (define v (verify-solution (lambda (local) 0) (literal-function 'x)
                             (lambda (local) (sgn (velocity local)))))
  (check-equal? (format "~s" (verdict-kinks v)) "((jump (sgn ((D x) t)) (= ((D x) t) 0)))")
  (define corner (holonomic (lambda (t q) (- (ref q 1) (abs (ref q 0))))))
  (define w (verify-solution L-free (lambda (t) (up 0 0)) #:constraints
                             (holonomic (lambda (t q) (- (ref q 1) (* 2 (ref q 0)))))))
  (check-pred proved? w)
  (check-equal?
   (format "~s" (verdict-kinks (verify-solution L-free (lambda (t) (up (* 'a t) (abs (* 'a t))))
                                                #:constraints corner)))
   "((kink (abs (* a t)) (= t 0)))"))

(test-case "a Lagrangian that takes numbers only is asked along the path"
  (define (L local)
    (- (* 1/2 (square (velocity local))) (if (< (coordinate local) 5) 0 1)))
  (check-true (solution? (lambda (t) 3) L)))

(test-case "flonums"
  (check-equal? (format "~s" (verdict-kinks (verify-solution L-free (lambda (t) (abs (- t 0.1))))))
                "((kink (abs (- t 0.1)) (= t 0.1)))"))

(test-case "the user's own t is not mistaken for the time"
  (check-equal? (format "~s" (verdict-kinks
                              (verify-solution L-free (lambda (t) (* t (sgn (- t 't)))))))
                "((jump (sgn (- t1 t)) (= t1 t)))"))

(test-case "a point on a kink refutes nothing"
  (define (L-harmonic s) (- (* 1/2 (square (velocity s))) (* 1/2 (square (coordinate s)))))
  (define v (verify-solution L-harmonic (lambda (t) (cos (* t (sgn t))))))
  (check-true (undecided? v))
  (check-equal? (format "~s" (verdict-kinks v)) "((jump (sgn t) (= t 0)))")
  (define w (verify-solution L-harmonic (lambda (t) (* 2 t (sgn t)))))
  (check-true (refuted? w))
  (check-not-equal? (cdr (assq 't (verdict-witness w))) 0))
