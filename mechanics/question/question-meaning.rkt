#lang racket/base
;; The meaning of a question about a Lagrangian: the Lagrangian, its mass matrix, the path or the
;; quantity (algebra/zero/kept-meaning.rkt).  No condition is named under which the question would
;; be about nothing.

(require (only-in racket/list split-at)
         "../algebra/expression/expression.rkt"
         "../calculus/derivative.rkt"
         "../error/refusal.rkt"
         (only-in "../hamiltonian/H-state.rkt" state->qp)
         "../lagrangian/Lagrange-equations.rkt" "../lagrangian/local-tuple.rkt"
         "../value/algebra.rkt" "../value/shape.rkt")

(provide mass-matrix
         meaning-of-solution meaning-of-quantity meaning-of-Lagrangian
         meaning-of-states meaning-of-quantity-in-phase-space meaning-of-Hamiltonian)

;; q : a path; n : the order of L; force : #f, or the force outside L
(define (meaning-of-solution L q n force)
  (define t (string->uninterned-symbol "t"))
  (define local ((Gamma q (+ n 2)) t))
  (define state (unknowns-like local))
  (about L state n force (expressions-in (lambda () (coordinate local))) (list t)))

;; state : of symbols; Q : a function of it, which shall not become a constant
(define (meaning-of-quantity L Q state force)
  (about L state 1 force (expressions-in (lambda () (Q state))) (scalars state)))

;; states : time -> (up t q p)
(define (meaning-of-states H states)
  (define t (string->uninterned-symbol "t"))
  (define state (states t))
  (about H state #f #f (expressions-in (lambda () (state->qp state))) (list t)))

;; state : (up t q p) of symbols
(define (meaning-of-quantity-in-phase-space H Q state)
  (about H state #f #f (expressions-in (lambda () (Q state))) (scalars state)))

;; state : of symbols
(define (meaning-of-Lagrangian L state) (about L state 1 #f '() '()))
(define (meaning-of-Hamiltonian H state) (about H state #f #f '() '()))

;; n : the order of a Lagrangian; #f of a Hamiltonian, which has no mass matrix
(define (about f state n force moving variables)
  (make-meaning (append (expressions-in (lambda () (f state)))
                        (if force (expressions-in (lambda () (force state))) '()))
                (if n (mass-matrix f state n) '())
                moving
                variables))

;; The expressions in the value of the thunk, which may fail at symbols; then none.
(define (expressions-in value)
  (filter expression? (scalars (if-raised raised? 0 (value)))))

;; The second derivatives by the highest velocities, as rows.
(define (mass-matrix L state n)
  (define highest (partial (+ n 1)))
  (if-raised raised? '()
    (define M (expressions-in (lambda () ((highest (highest (scalar-valued 'L L))) state))))
    (define width (integer-sqrt (length M)))
    (if (= (length M) (* width width)) (rows-of M width) '())))

(define (rows-of xs width)
  (if (null? xs)
      '()
      (let-values ([(row others) (split-at xs width)]) (cons row (rows-of others width)))))
