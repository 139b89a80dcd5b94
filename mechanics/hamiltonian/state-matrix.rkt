#lang racket/base
;; States as columns of their scalars, and back.

(require "H-state.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/wrong-argument.rkt"
         "../value/shape.rkt" "../value/matrix/matrix.rkt")

(provide H-state->matrix matrix->H-state)

(define (H-state->matrix state)
  (check-H-state 'H-state->matrix state)
  (apply matrix-by-rows (map list (scalars state))))

;; like : a state of the shape wanted; without it, coordinates and momenta that are tuples
(define (matrix->H-state m [like #f])
  (unless (and (matrix? m) (= (m:num-cols m) 1) (odd? (m:num-rows m)) (> (m:num-rows m) 2))
    (complain-of-argument 'matrix->H-state
                          "a matrix of one column, with the time, n coordinates and n momenta" m))
  (when like (check-H-state 'matrix->H-state like))
  (define shape (or like (literal-Hamiltonian-state (quotient (m:num-rows m) 2))))
  (unless (= (shape-length shape) (m:num-rows m))
    (complain 'matrix->H-state "the state has ~a scalars and the matrix ~a\n  state: ~a"
              (shape-length shape) (m:num-rows m) (value->text shape)))
  (scalars->structure shape (lambda (k) (matrix-ref m k 0))))
