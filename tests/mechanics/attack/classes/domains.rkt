#lang racket/base
;; Questions about systems that have no real value where their solution, equilibrium or conserved
;; quantity is said to be, though derivatives have; and about the same where there are values.

(require "../statement.rkt" "../template.rkt")

(provide domains)

;; V is a potential with C at rest; at the speed S the Lagrangian A may have no value; E is a
;; constant, of which there may be no value anywhere, as there may be none of N.
(define (domains)
  (define entry (pick questions))
  (define-values (V C) (random-rest))
  (define u (pick '(x v (+ x v) t (* x v))))
  (define (constant u) (filled (pick constants) `((U . ,u))))
  (define S (pick '(2 -1 1/2 -3 3/2 c)))
  (define A (pick fast))
  (question-of (car entry) (cadr entry)
               `((V . ,V) (C . ,C) (VC . ,(substituted V 'x C)) (S . ,S) (A . ,A)
                 (AS . ,(substituted A 'v S)) (E . ,(constant u)) (ET . ,(constant 't))
                 (EX . ,(constant 'x)) (N . ,(pick nowhere)))))

(define questions
  '(((verify-solution (line (- free V)) (path C)) (domain VC))
    ((verify-equilibrium (line (- free V)) C) (domain VC))
    ((verify-Hamiltonian-solution (state (+ (* 1/2 (square p)) V)) (path C) (path 0)) (domain VC))
    ((map (lambda (e) (list (equilibrium-coordinates e) (equilibrium-conditions e)))
          (equilibria (line (- free V)) local))
     (found V))
    ((verify-solution (line A) (path (+ 1 (* S t)))) (domain AS))
    ((verify-solution (line free) (path (+ t ET))) (domain ET))
    ((verify-Hamiltonian-solution (state (* 1/2 (square p))) (path (+ t ET)) (path 1)) (domain ET))
    ((verify-conserved (line free) (line (+ v E)) local) (domain E))
    ((verify-equivalent-Lagrangians (line free) (line (+ free E)) local) (domain E))
    ((verify-total-time-derivative (line (+ v E)) local) (domain E))
    ((verify-Hamilton-Jacobi (state (* 1/2 (square p)))
                             (action (- (+ (* k x) EX) (* 1/2 (square k) t))) 't 'x)
     (domain EX))
    ((verify-canonical-map (state (up t x (+ p EX))) local-state) (domain EX))
    ((let ([L (line (- free N))]) (verify-conserved L (Lagrangian->energy L) local)) (domain N))
    ((verify-ignorable (line (- free N)) 'x local) (domain N))
    ((verify-equivalent-Lagrangians (line (- free N)) (line (* 2 (- free N))) local)
     (domain N))))

;; (potential (place . slope there) ...): of each some places are outside.
(define potentials
  '(((log (- x 2)) (1 . -1) (3 . 1) (-1 . -1/3)) ((log x) (-1 . -1) (2 . 1/2) (-3 . -1/3))
    ((log (- x)) (1 . 1) (-2 . -1/2) (5 . 1/5)) ((atanh x) (2 . -1/3) (-3 . -1/8) (1/2 . 4/3))
    ((log (- 1 (square x))) (2 . 4/3) (-3 . -3/4) (1/2 . -4/3))
    ((log (- (square x) 4)) (1 . -2/3) (-1 . 2/3) (3 . 6/5))
    ((log (/ (- x 1) (- 3 x))) (0 . -2/3) (4 . -2/3) (2 . 2))
    ((log (sqrt (- x 2))) (1 . -1/2) (3 . 1/2)) ((log (- -1 (square x))) (0 . 0) (1 . 1))
    ((log (+ 1 (square x))) (0 . 0) (1 . 1)) ((sqrt (- (square x) 2)) (0 . 0))
    ((log (- (cos x) 2)) (0 . 0)) ((log (- a (square x))) (0 . 0)) ((log (cos x)) (0 . 0))
    ((log (- (square x) (square b))) (0 . 0)) ((expt (- (square x) 2) 3/2) (0 . 0))))

;; -> one of them, less a force and half a spring, and the place that is so at rest
(define (random-rest)
  (define entry (pick potentials))
  (define place (pick (cdr entry)))
  (define-values (c slope) (values (car place) (cdr place)))
  (define k (if (or (zero? c) (chance 2)) 0 (/ slope c)))
  (values `(- ,(car entry) ,(if (zero? k) `(* ,slope x) `(* 1/2 ,k (square x)))) c))

(define fast
  '((- (sqrt (- 1 (square v)))) (* v (log v)) (sqrt v) (log (- 1 v)) (acosh v) (* v (atanh v))
    (expt (- v 1) 3/2) (log (- (square v) b)) (asin v)))

;; The last four have values.
(define constants
  '((- (log (- U)) (log U)) (- (log (- -1 (square U))) (log (+ 1 (square U))))
    (+ (asin (+ 2 (square U))) (acos (+ 2 (square U)))) (- (log (- U 2)) (log (- 2 U)))
    (/ (sqrt U) (sqrt (- U))) (/ (sqrt (- -1 (square U))) (sqrt (+ 1 (square U))))
    (- (log (- (cos U) 2)) (log (- 2 (cos U)))) (- (log (- (exp U))) U)
    (- (log (- (square (sin U)) 1)) (log (square (cos U))))
    (- (log (- U)) (log (* -2 U))) (- (log (- U 2)) (log (- (* 2 U) 4))) (+ (asin U) (acos U))
    (/ (sqrt (- 1 U)) (sqrt (- 2 (* 2 U))))))

(define nowhere
  '((log (- -1 (square v))) (sqrt (- -1 (square v))) (log (- -1 (square x))) (acosh (cos v))
    (asin (+ 2 (square x))) (sqrt (- (cos x) 2)) (log (- (exp v))) (atanh (+ 1 (square x)))
    (sqrt (- 1 (square v))) (log (- x 1)) (log v)))
