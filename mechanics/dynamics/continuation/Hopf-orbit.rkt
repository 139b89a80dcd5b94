#lang racket/base
;; The periodic orbits that begin at a point of Hopf's: there an equilibrium has the eigenvalues
;; ±iω, and orbits of the period 2π/ω, as small as one likes, turn about it in the plane of their
;; eigenvectors, where J² = −ω² (Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory, 3.4).

(require racket/flonum
         racket/list
         "branch-start.rkt" "curve-step.rkt" "orbit-branch.rkt" "orbit-equations.rkt"
         "../../error/failure.rkt"
         "../../numeric/constants.rkt" "../../numeric/flvector.rkt"
         (only-in "../../numeric/linear-algebra/flonum-systems.rkt" product)
         "../../numeric/linear-algebra/row-matrix.rkt"
         "../../numeric/linear-algebra/singular-values.rkt")

(provide onset-of-orbits)

(define who 'switch-branch)

;; How far the first orbit is from the equilibrium, in scaled unknowns: the first for which there
;; is an orbit is taken.
(define sizes '(1e-2 3e-3 1e-3 1e-4))

;; e : equations of the equilibria; systems : parameter -> state derivative; state : at the point p
;; -> the family of the orbits, and a small one
(define (onset-of-orbits e systems state p l)
  (define x (point-x p))
  (define n (- (flvector-length x) 1))
  (define omega (frequency (point-spectrum p)))
  (define period (/ :2pi omega))
  (define o (orbits-from who systems state period #f 1e-12 (flvector-ref x n)))
  (define x0 (unknowns-at o state period (flvector-ref x n)))
  (define orbits (orbit-equations o x0 (parameter-scale l)))
  (define w (turning-direction (submatrix (evaluated-slopes ((equations-evaluate e) x x))
                                          (range n) (range n))
                               omega))
  (define t (apply flvector (append (flvector->list w) '(0.0 0.0))))
  (define scaled (flvector-map fl/ t (equations-scales orbits)))
  (define unit (flvector-scaled (fl/ 1.0 (norm scaled)) scaled))
  (define first-point
    (for/or ([size (in-list sizes)])
      (point-across orbits (along x0 (fl/ size (norm scaled)) t) unit)))
  (unless first-point
    (raise-not-convergent who "no periodic orbit was found near the equilibrium" state #f
                          #:show? #f "state" state "period" period))
  (values (orbit-family o orbits) first-point))

;; That of the pair which is nearest to the imaginary axis
(define (frequency spectrum)
  (imag-part (argmin (lambda (l) (abs (real-part l)))
                     (filter (lambda (l) (> (imag-part l) 0)) spectrum))))

;; A vector on which J² is −ω²
(define (turning-direction J omega)
  (define turned (rows-combine + (product J J) (unit-rows (vector-length J) (* omega omega) 0.0)))
  (define-values (_us _sizes vs) (singular-values (columns-of turned)))
  (last vs))
