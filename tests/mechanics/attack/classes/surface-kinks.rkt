#lang racket/base
;; Questions about what jumps or turns on a surface, made of roots of sums of squares that
;; vanish together there, or of a factor that touches zero, or what has no value there and stays
;; bounded; and about smooth neighbours.

(require "../statement.rkt" "../template.rkt")

(provide surface-kinks)

;; All that follows each question must be smooth at the place, along t and x.
(define (surface-kinks)
  (define-values (u w) (values (pick '(x x x (sin x) (- x t))) (pick '(h 1 v))))
  (define (one-of table u)
    (define choices `((U . ,u) (W . ,w)))
    (filled (filled (pick table) (list (cons 'R (filled (pick radicands) choices)))) choices))
  (define entry (pick questions))
  (question-of (car entry)
               `(smooth ,@(for/list ([e (in-list (cdr entry))]) (list e place '(t x))))
               `((K . ,(one-of roots u)) (J . ,(one-of (pick steps) u)) (JT . ,(one-of jumps 't))
                 (M . ,(one-of moduli 'x)) (MT . ,(one-of moduli 't)) (B . ,(pick between)))))

(define place '((t . 0) (x . 0) (y . 0) (v . 7/4) (u . 1) (p . 7/4) (h . 3/2) (k . 2)))

(define questions
  '(((let ([L (line (- free K))]) (verify-conserved L (Lagrangian->energy L) local)) (- free K))
    ((verify-conserved (line (- free J)) (line v) local) (- free J))
    ((verify-conserved (line free) (line (* v J)) local) (* v J))
    ((verify-conserved (line free) (line (+ v J)) local) (+ v J))
    ((verify-conserved (plane (+ (square u) (square v) B)) (plane (+ u v)) local-plane) B)
    ((verify-conserved (plane (+ (square u) (square v) (sgn B))) (plane (+ u v)) local-plane)
     (sgn B))
    ((verify-solution (line (- free J)) (path (* 7/4 t))) (- free J))
    ((verify-solution (line free) (path (+ t JT))) JT)
    ((verify-solution (line free) (path (- (* h t) (* k MT)))) MT)
    ((verify-solution (line (- free (* 1/8 (square x)))) (path (sqrt (- 2 (* 2 (cos t))))))
     (sqrt (- 2 (* 2 (cos t)))))
    ((verify-solution (line (+ free (* 1/8 (square x)))) (path (sqrt (* 2 (- (cosh t) 1)))))
     (sqrt (* 2 (- (cosh t) 1))))
    ((verify-ignorable (line (+ free J)) 'x local) (+ free J))
    ((verify-total-time-derivative (line (* v J)) local) (* v J))
    ((verify-total-time-derivative (line (+ v J)) local) (+ v J))
    ((verify-canonical-map (state (up t x (+ p J))) local-state) J)
    ((verify-canonical-map (state (up t (* x J) (/ p J))) local-state) (* x J) (/ p J))
    ((verify-Hamiltonian-solution (state (+ (* 1/2 (square p)) J)) (path (* 7/4 t)) (path 7/4)) J)
    ((verify-Hamilton-Jacobi (state (* 1/2 (square p))) (action (- (* k M) (* 1/2 (square k) t)))
                             't 'x)
     M)
    ((verify-Hamilton-Jacobi (state (* 1/2 (square p)))
                             (action (- (* k (+ x J)) (* 1/2 (square k) t))) 't 'x)
     J)
    ((verify-equivalent-Lagrangians (line (- free K)) (line (+ J (- (square v) (* 2 K)))) local)
     J)))

;; Not of U alone, or smooth, or with zeros in fewer dimensions: the last five.
(define radicands
  '((+ (square U) (expt U 4)) (+ (square U) (square (* U W))) (- 1 (cos U)) (- (cosh U) 1)
    (square U) (* (square U) (+ 1 (square W))) (square (sin U)) (* (exp W) (square U))
    (+ (square (sin U)) (square (- 1 (cos U)))) (+ (square (* h U)) (* k (expt U 4)))
    (square (- (exp U) 1))
    (+ (square U) (square W)) (+ (square U) (square h)) (expt U 4) (+ 1 (square U))
    (+ (square U) (* U W) (square W))))

(define roots '((sqrt R) (expt R 1/2) (expt R 3/2) (* k (sqrt R)) (abs U)))
(define jumps
  '((sgn (sqrt R)) (sgn (+ U (sqrt R))) (sgn (* U (sqrt R))) (sgn U) (abs (sgn R)) (sgn (+ h R))
    (* (sqrt R) (sgn R)) (sqrt R)))

;; Without a value at U = 0; the last ones are unbounded, or lead to a value.
(define gaps
  '((/ U (abs U)) (/ (abs U) U) (/ U (sqrt (square U))) (* h U (expt (square U) -1/2))
    (atan (/ 1 U)) (+ (atan U) (atan (/ 1 U))) (tanh (/ 1 U)) (/ 1 (+ 1 (exp (/ 1 U))))
    (log (+ 2 (/ U (abs U)))) (exp (/ U (abs U))) (/ (abs U) (sin U)) (/ R (* U (abs U)))
    (/ (sqrt R) U) (atan (/ (sqrt R) (square U))) (sin (/ (* h U) (sqrt R)))
    (/ 1 U) (/ k (abs U)) (log (square U)) (exp (/ -1 (square U))) (/ (sin U) U)))

(define steps (list jumps gaps))

(define moduli
  '((/ (sqrt (+ (square U) (expt U 4))) (sqrt (+ 1 (square U)))) (sqrt (square U)) (abs U)
    (/ (sqrt (+ (square U) (square (* h U)))) (sqrt (+ 1 (square h))))
    (/ (sqrt (+ (expt U 6) (square U))) (sqrt (+ 1 (expt U 4))))
    (/ (sqrt (* (exp U) (square U))) (exp (/ U 2))) (expt (expt U 4) 1/4)
    (sqrt (+ (* 1/2 (square U)) (* 1/2 (square U)))) (+ U (sgn (+ U (abs U))))))
(define between
  '((sqrt (+ (square (- (cos x) (cos y))) (square (- (sin x) (sin y))))) (abs (- x y))
    (sqrt (- 2 (* 2 (cos (- x y))))) (sqrt (+ (square (- x y)) (square h)))
    (sqrt (+ (square (- x y)) (expt (- x y) 4))) (- x y (abs (- x y)))))
