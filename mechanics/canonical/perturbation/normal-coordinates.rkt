#lang racket/base
;; The states of a normal form (Birkhoff.rkt).
;;
;; Coordinates and momenta of the modes are polynomials of degree 1, and go through the exponentials
;; of the generators as the Hamiltonian does; each generator raises the degree by one more.  The old
;; state is the equilibrium and, beside it, their product with the matrix M; back, with
;; M⁻¹ = −J Mᵀ J, its areas with the columns of M.

(require racket/list
         "Birkhoff.rkt" "complex-polynomial.rkt"
         "../Lie/Lie-triangle.rkt"
         "../quadratic/phase-space-equilibrium.rkt"
         "../../calculus/expression-function.rkt"
         "../../generic/arithmetic.rkt" "../../generic/function.rkt"
         "../../generic/sums-and-products.rkt"
         "../../hamiltonian/H-state.rkt"
         "../../value/matrix/matrix.rkt" "../../value/matrix/row-products.rkt"
         "../../value/shape.rkt")

(provide normal-form-transformation normal-form-inverse)

;; new state ↦ old state, to the degree of N
(define (normal-form-transformation N)
  (check-normal-form 'normal-form-transformation N)
  (define images (carried N 1 (cdr (scalars (normal-form-state N)))))
  (state-function 'normal-form-transformation N
                  (map g:+ (normal-form-place N) (rows-times-list (rows-of N) images))))

;; Lists, of the matrix
(define (rows-of N) (map vector->list (vector->list (matrix-rows (normal-form-matrix N)))))

;; old state ↦ new state
(define (normal-form-inverse N)
  (check-normal-form 'normal-form-inverse N)
  (define beside (map g:- (cdr (scalars (normal-form-state N))) (normal-form-place N)))
  (define columns (apply map list (rows-of N)))
  (define n (quotient (length beside) 2))
  (define-values (of-q of-p) (split-at columns n))
  (define modes
    (append (for/list ([c (in-list of-p)]) (area beside c n))
            (for/list ([c (in-list of-q)]) (area c beside n))))
  (state-function 'normal-form-inverse N (carried N -1 modes)))

;; Σ u_q w_p − u_p w_q
(define (area u w n)
  (define (half-product a b) (g:for/sum ([x (in-list a)] [y (in-list b)]) (g:* x y)))
  (g:- (half-product (take u n) (drop w n)) (half-product (drop u n) (take w n))))

;; Coordinates and momenta of the modes after the exponentials, at the values xs of those before
(define (carried N sign xs)
  (define m (normal-form-modes N))
  (for/list ([k (in-range (length xs))])
    (define terms
      (carry (cons (real-variable m k) (map (lambda (W) (make-hasheqv)) (normal-form-Ws N)))
             (normal-form-Ws N) (polynomial-bracket m) polynomial-sum polynomial-scale
             #:sign sign))
    (polynomial->expression m (for/fold ([sum (make-hasheqv)]) ([f (in-list terms)])
                                (polynomial-sum sum f))
                            xs)))

(define (state-function who N values)
  (define state (normal-form-state N))
  (define formula (place->state state values))
  (unary-function (lambda () (list who 'N)) (at)
    (check-state-like who state at)
    (evaluate-at formula state at)))
