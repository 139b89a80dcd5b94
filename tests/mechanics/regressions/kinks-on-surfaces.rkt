#lang racket/base
;; A root of a sum of squares counted as a distance wherever it stood, though all the squares may
;; vanish on a surface, as in √(x² + x⁴); and a factor that touches 0 without becoming negative, as
;; 1 − cos x, counted as an end.  With such steps quantities were proved conserved that jump.

(require mechanics
         "../support/checks.rkt")

(define state (up 't (up 'x 'y) (up 'u 'v)))

;; Is the energy of a particle conserved in the potential V?
(define (energy-verdict V)
  (define (V-of s) (V (ref s 1 0) (ref s 1 1)))
  (define (T s) (* 1/2 'm (square (velocity s))))
  (verify-conserved (lambda (s) (- (T s) (V-of s))) (lambda (s) (+ (T s) (V-of s))) state))

(define-syntax-rule (potentials (x y) e ...) (list (cons 'e (lambda (x y) e)) ...))

(define (check-kinks entry)
  (define v (energy-verdict (cdr entry)))
  (check-equal? (verdict-reason v) 'kinks (format "~s" (car entry))))

(define (check-smooth entry . conditions)
  (define v (energy-verdict (cdr entry)))
  (check-pred proved? v (format "~s" (car entry)))
  (check-equal? (format "~s" (verdict-assumptions v)) (format "~s" conditions)
                (format "~s" (car entry))))

(test-case "squares that vanish together on a surface"
  (for-each check-kinks
            (potentials (x y)
              (sqrt (+ (square x) (expt x 4)))
              (sqrt (+ (square x) (square (* x y))))
              (sqrt (+ (square (- (cos x) (cos y))) (square (- (sin x) (sin y)))))
              (sqrt (+ (square x) (square (sin x))))
              (sqrt (+ (square x) (square (- (exp x) 1))))
              (sqrt (+ (square (- x y)) (square (- (square x) (square y))))))))

(test-case "factors that touch 0"
  (for-each check-kinks
            (potentials (x y)
              (sqrt (- 1 (cos x)))
              (sqrt (+ 1 (cos x)))
              (sqrt (- (cosh x) 1))
              (expt (- 1 (sin (* 2 x))) 1/2)
              (* y (sqrt (- (exp (* 2 x)) (* 2 (exp x)) -1))))))

(test-case "factors that share a zero, or have a least value"
  (for-each check-kinks
            (potentials (x y)
              (sqrt (* x (sin x)))
              (sqrt (* (- x y) (- (exp x) (exp y))))
              (sqrt (- (exp x) 1 x))
              (sqrt (- (exp (square x)) 1))
              (sqrt (log (+ 1 (square x))))
              (sqrt (- (sqrt (+ 1 (square x))) 1))
              (acos (exp (- (square x))))
              (sqrt (- 1 (cos (* 9 x))))
              (sqrt (- (cosh (* 12 x)) 1))
              (expt (square x) 'n)
              (sqrt (+ (square (* x (cos 'a))) (square (* x (sin 'a)))))
              (sqrt (atan (sin x) (cos x))))))

(test-case "a path is differentiated as often as the order asks"
  (define (L s) (* 1/2 (square (ref s 3))))
  (check-pred undecided? (verify-solution L (lambda (t) (expt (square t) 3/2)) #:order 2))
  (check-pred proved? (verify-solution L cube #:order 2)))

(test-case "distances, and what has two derivatives, are none"
  (for-each check-smooth
            (potentials (x y)
              (sqrt (+ (square x) (square y)))
              (sqrt (+ (square x) (* x y) (square y)))
              (sqrt (+ (/ (square x) (square 'a)) (/ (square y) (square 'b))))
              (+ (/ 'k (sqrt (+ (square (- x 'c)) (square y))))
                 (/ 'k (sqrt (+ (square (+ x 'c)) (square y)))))
              (* 1/2 'k (square (- (sqrt (+ (square x) (square y))) 'l)))
              (sqrt (+ (square x) (square (sin y))))
              (expt (+ (square x) (square y)) 3/2)
              (abs (- 1 (cos x)))
              (cube (abs x))
              (* x x x (sgn x))
              (cos (abs x)))))

(test-case "but the first derivative may be missing"
  (for-each check-kinks (potentials (x y) (* x (abs x)) (square (- (abs x) 'l)) (abs (sin x)))))

(test-case "or the value at one point may be another"
  (define (jumps V) (verdict-reason (energy-verdict V)))
  (check-equal? (jumps (lambda (x y) (sgn (square x)))) 'kinks)
  (check-equal? (jumps (lambda (x y) (abs (sgn (+ (square x) (expt x 4)))))) 'kinks)
  (check-equal? (jumps (lambda (x y) (sgn (sqrt (expt x 4))))) 'kinks))

(test-case "parameters at which a distance is a kink are told"
  (define-syntax-rule (told (x y) [e condition ...] ...)
    (begin (check-smooth (car (potentials (x y) e)) 'condition ...) ...))
  (told (x y)
        [(sqrt (+ (square x) (square 'h))) (> (abs h) 0)]
        [(sqrt (+ (square 'l) (square 'd) (* -2 'l 'd (cos x))))
         (> (abs (- d l)) 0) (> (abs (+ d l)) 0)]
        [(sqrt (+ 'a (* 'b (cos x)))) (> (abs (- a b)) 0) (> (abs (+ a b)) 0)])
  (assuming ('(> h 0))
    (check-equal? (format "~a" (energy-verdict (lambda (x y) (sqrt (+ (square x) (square 'h))))))
                  "proved: the residual is zero\n  given: (> h 0)")))

(test-case "where a potential has no value is no kink"
  (for-each check-smooth
            (potentials (x y)
              (/ 'k (sqrt (square x)))
              (* 'k (log (abs x)))
              (/ 'k (abs (- x y)))
              (* 'k (log (abs (- x y))))
              (expt (square x) -1/2)))
  (check-pred proved?
              (verify-solution (lambda (s) (+ (* 1/2 (square (velocity s)))
                                              (/ (* 'G 'M) (coordinate s))))
                               (lambda (t) (expt (* 9/2 'G 'M (square t)) 1/3)))))

(test-case "a place, or a parameter, at which something is divided by 0"
  (check-pred proved? (energy-verdict (lambda (x y)
                                        (+ (/ 'k (sqrt (+ (square (+ x (/ 'c 'a))) (square y))))
                                           (/ 'k (sqrt (+ (square (- x (/ 'a 'c))) (square y))))))))
  (check-pred proved? (energy-verdict (lambda (x y) (log (abs (/ (abs x) (+ x (/ 1 x)))))))))

(test-case "other questions that differentiate"
  (define line (up 't 'x 'v))
  (define H (lambda (s) (* 1/2 (square (ref s 2)))))
  (define (cone x) (sqrt (+ (square x) (expt x 4))))
  (check-pred undecided? (verify-Hamilton-Jacobi
                          H (lambda (t x) (- (* 'k (sqrt (square x))) (* 1/2 (square 'k) t)))
                          't 'x))
  (check-pred undecided? (verify-total-time-derivative
                          (lambda (s) (* (velocity s) (cone (coordinate s)))) line))
  (check-pred undecided? (verify-canonical
                          (lambda (s) (up (ref s 0) (ref s 1) (+ (ref s 2) (cone (ref s 1)))))
                          (up 't 'q 'p)))
  (check-pred undecided? (verify-canonical
                          (lambda (s) (up (ref s 0) (ref s 1) (+ (ref s 2) (sgn (ref s 1)))))
                          (up 't 'q 'p))))
