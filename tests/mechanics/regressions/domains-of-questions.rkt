#lang racket/base
;; Only the residual was asked for its value: where the Lagrangian had none, or the path, or the
;; quantity, solutions were proved, equilibria found and claims refuted all the same.

(require (only-in racket/string string-prefix?)
         mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define line (up 't 'x 'v))
(define ((on-line V) s) (- (* 1/2 (square (velocity s))) (V (coordinate s))))
(define (L-log s) (- ((on-line (lambda (x) (* 1/2 (square x)))) s) (log (- (coordinate s) 2))))

;; Undecided, as that part has no value
(define (check-nowhere v part)
  (check-equal? (verdict-reason v) 'nowhere-defined)
  (check-equal? (verdict-remarks v) (list (string-append part " has no real value"))))

(test-case "a path where the Lagrangian has no value"
  (check-nowhere (verify-solution L-log (lambda (t) 1)) "(log (+ -2 1))")
  (check-nowhere (verify-solution (on-line (lambda (x) (- (log (- x)) (log x)))) (lambda (t) t))
                 "(- (log (* -1 t)) (log t))")
  (check-nowhere (verify-solution (lambda (s) (asin (velocity s))) (lambda (t) (+ 1 (* 2 t))))
                 "(asin 2)")
  (check-nowhere (verify-solution (lambda (s) (sqrt (- 1 (square (velocity s)))))
                                  (lambda (t) (* 2 t)))
                 "(sqrt (- 1 (* 2 2)))")
  (check-pred proved? (verify-solution (lambda (s) (sqrt (- 1 (square (velocity s)))))
                                       (lambda (t) (/ t 2)))))

(test-case "a path without a value"
  (check-nowhere (verify-Hamiltonian-solution (lambda (s) (* 1/2 (square (ref s 2))))
                                              (lambda (t) (+ t (- (log (- (exp t))) t)))
                                              (lambda (t) 1))
                 "(log (* -1 (exp t)))")
  (check-pred proved? (verify-solution (on-line (lambda (x) (* 1/2 (square x))))
                                       (lambda (t) (exp (* +i t))))))

(test-case "equilibria"
  (define (coordinates V) (map equilibrium-coordinates (equilibria (on-line V) line)))
  (check-nowhere (verify-equilibrium L-log 1) "(log (+ -2 1))")
  (check-equal? (coordinates (lambda (x) (+ (/ x 3) (atanh x)))) '())
  (check-equal? (coordinates (lambda (x) (+ (log x) x))) '())
  (check-equal? (coordinates (lambda (x) (- (log x) x))) '(1))
  (check-equal? (coordinates (lambda (x) (+ (* 'a x) (log (cos x))))) (list (atan 'a)))
  (check-message "normal-modes: the Lagrangian has no real value at these coordinates: 1"
                 (normal-modes L-log 1)))

(test-case "quantities that have a value nowhere are neither conserved nor not"
  (define (V x) (log (- -1 (square x))))
  (check-nowhere (verify-conserved (on-line V) (Lagrangian->energy (on-line V)) line)
                 "(log (- -1 (* x x)))")
  (check-nowhere (verify-conserved (on-line (lambda (x) 0)) (lambda (s) (V (coordinate s))) line)
                 "(log (- -1 (* x x)))")
  (check-nowhere (verify-ignorable (on-line (lambda (x) (atanh (+ 1 (square x))))) 'x line)
                 "(atanh (+ 1 (* x x)))")
  (check-nowhere (verify-equivalent-Lagrangians (on-line V) (lambda (s) (* 2 ((on-line V) s))) line)
                 "(log (- -1 (* x x)))")
  (check-equal? (ignorable-coordinates (lambda (s) (log (- -1 (square (velocity s))))) line) '()))

(test-case "functions that have values at no common point"
  (define v (verify-conserved (on-line (lambda (x) (log x))) (lambda (s) (sqrt (- (coordinate s))))
                              line))
  (check-equal? (verdict-reason v) 'nowhere-defined)
  (check-true (string-prefix? (car (verdict-remarks v))
                              "at no point do all of these have real values: ")))

(test-case "a motion whose derivative exists nowhere"
  (define v (verify-solution (lambda (s) (- (* 1/2 (square (velocity s)))
                                            (sqrt (square (coordinate s)))))
                             (lambda (t) (up 0 0))))
  (check-pred undecided? v)
  (check-equal? (verdict-remarks v) '("sqrt: has no derivative at 0")))

(test-case "an equilibrium on a kink"
  (define v (verify-equilibrium (on-line (lambda (x) (abs (- x 'a)))) 'a))
  (check-equal? (format "~a" v)
                (string-append "undecided: the residual is neither proved nor refuted to be zero\n"
                               "  residual: +nan.0\n"
                               "  evidence: it is not a number\n"
                               "  kink: (abs 0) everywhere\n"
                               "  note: abs: has no derivative at 0")))

(test-case "a declared sign of another kind does not hide that a factor is not 0"
  (define (L s) (* 1/2 (square (velocity s))))
  (define (L-hidden s)
    (+ (* 'h (L s)) (* (exp (coordinate s)) (+ (abs (- 'h 5)) 'h -5))))
  (assuming ('(< h 5))
    (check-equal? (format "~s" (verdict-assumptions
                                (verify-equivalent-Lagrangians L L-hidden line)))
                  "((< h 5) (> (abs h) 0))")))

(test-case "nor what keeps the rank of singular masses"
  (define (sum s) (+ (ref s 2 0) (ref s 2 1)))
  (define (L s) (* 1/2 (square (sum s))))
  (define (L-fourth s) (* 1/12 'c (expt (sum s) 4)))
  (define plane (up 't (up 'x 'y) (up 'u 'v)))
  (for ([v (in-list (list (verify-equivalent-Lagrangians L L-fourth plane)
                          (verify-equivalent-Lagrangians L-fourth L plane)))])
    (check-pred proved? v)
    (check-equal? (format "~s" (verdict-assumptions v)) "((> (abs c) 0))")))

(test-case "reasons and conditions are true and real"
  (define v (prove-zero (exp (- -1000 (square 'x)))))
  (check-pred refuted? v)
  (check-equal? (format "~a" v)
                (string-append "refuted: the residual is not zero\n"
                               "  residual: (exp (+ (* -1 (expt x 2)) -1000))\n"
                               "  at: x = 1\n"
                               "  value: 1.86734e-435"))
  (check-equal? (verdict-conditions (prove-zero (- (* +i 'x) 3))) '()))

(test-case "what multiplies accelerations is not 0"
  (define (L s) (* 1/2 'c (square (velocity s))))
  (define (told Q) (format "~s" (verdict-assumptions (verify-conserved L Q line))))
  (check-equal? (told velocity) "((> (abs c) 0))")
  (check-equal? (told (lambda (s) (* 'c (velocity s)))) "()")
  (check-equal? (told (Lagrangian->energy L)) "()"))
