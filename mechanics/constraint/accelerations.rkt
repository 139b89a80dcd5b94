#lang racket/base
;; Accelerations and multipliers from the state.
;;
;; With the mass matrix M = ∂₂∂₂L, the force f = ∂₁L + Q − (∂₀ + v ∂₁)∂₂L and the Jacobian J
;; of the constraints,
;;
;;     M a − Jᵀ λ = f,    J a = −γ.
;;
;; Where M has an inverse, a = M⁻¹ f + M⁻¹Jᵀ λ leaves one equation for each constraint,
;;
;;     (J M⁻¹ Jᵀ) λ = −γ − J M⁻¹ f,
;;
;; which keeps formulas short, for M is diagonal more often than not.  Where it has none,
;; there may be inertia in all directions that are left: then both are solved together.

(require (only-in racket/vector vector-append vector-drop vector-take)
         "constraint.rkt" "constraint-jacobian.rkt" "dependence.rkt"
         "../calculus/derivative.rkt"
         "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../lagrangian/external-force.rkt" "../lagrangian/Lagrange-equations.rkt"
         "../lagrangian/local-tuple.rkt" "../lagrangian/state-derivative.rkt"
         "../value/shape.rkt" (only-in "../value/structure.rkt" ref)
         "../value/matrix/row-products.rkt" "../value/matrix/row-systems.rkt")

(provide constrained-accelerations constraint-forces
         ;; for motions: numbers in rows
         accelerations-with mass-rows solve-constrained)

;; (t, q, v) ↦ (up accelerations multipliers)
(define-plain (constrained-accelerations L constraints #:force [Q #f])
  (define who 'constrained-accelerations)
  (define solve (accelerations-and-multipliers who L constraints Q))
  (named who L constraints Q
         (lambda (state)
           (define-values (a multipliers) (solve state))
           (up a multipliers))))

;; (t, q, v) ↦ Σ λ ∂G/∂q
(define-plain (constraint-forces L constraints #:force [Q #f])
  (define who 'constraint-forces)
  (define cs (gather-with who L constraints))
  (define solve (accelerations-and-multipliers who L cs Q))
  (named who L cs Q
         (lambda (state)
           (define-values (a multipliers) (solve state))
           (force-of-multipliers who cs state multipliers))))

(define (named who L constraints Q f)
  (unary-function (apply call-datum who L (gather who constraints) (force->datum Q)) (state)
    (f state)))

;; -> (state -> a, of the shape of the velocities, and λ, of the shape of the constraints)
(define (accelerations-and-multipliers who given-L constraints Q)
  (define cs (gather-with who given-L constraints))
  (define solve (accelerations-with who (scalar-valued who given-L) cs (external-force who Q #f)))
  (lambda (state)
    (check-velocity who state)
    (define shape (checked-constraint-values who cs state))
    (define-values (a multipliers) (solve state))
    (values (vector->structure (velocity state) a) (vector->structure shape multipliers))))

;; The same in vectors.
;; choose : list, one element for each constraint -> the elements of the constraints to keep
(define ((accelerations-with who L cs outside [choose values]) state)
  (solve-constrained who (mass-rows L state)
                     (choose (jacobian-rows who cs state))
                     (applied-force who L outside state)
                     (choose (map g:negate (drifts who cs state)))))

;; The mass matrix, as rows.
(define (mass-rows L state)
  (define-values (t q v) (state-parts state))
  (define P ((partial 2) L))
  (rows-of-function (lambda (v) (P (up t q v))) v))

;; f, a vector.
(define (applied-force who L outside state)
  (define-values (t q v) (state-parts state))
  (define P ((partial 2) L))
  (define-values (momentum rate)
    (value-and-derivative-along (lambda (tq) (P (up (ref tq 0) (ref tq 1) v))) (up t q) (up 1 v)))
  (define inside (g:- (((partial 1) L) state) rate))
  (list->vector
   (scalars (if outside (g:+ inside (force-like who inside (outside state))) inside))))

;; ---------------------------------------------------------------------------
;; The linear system

;; M : vector of rows; J : list of rows; f : vector; c : list, the value that J a is to have
;; -> a and λ, vectors
(define (solve-constrained who M J f c)
  (define by-inertia
    (if-raised exn:fail:mechanics:singular:matrix? #f
      (rows-solve-each who M M (list->vector (cons f J)))))
  (if by-inertia
      (solve-by-inertia who by-inertia J c)
      (solve-together who M J f c)))

;; columns : M⁻¹f, then those of M⁻¹Jᵀ
(define (solve-by-inertia who columns J c)
  (define free (vector-ref columns 0))
  (define pulled (cdr (vector->list columns)))
  (define S
    (for/vector ([g (in-list J)])
      (for/vector ([x (in-list pulled)]) (sum-of-products g x))))
  (define right (for/vector ([g (in-list J)] [x (in-list c)]) (g:- x (sum-of-products g free))))
  (define multipliers (solve-or-explain who J S right))
  (define a
    (for/fold ([a free]) ([m (in-vector multipliers)] [x (in-list pulled)])
      (for/vector ([a (in-vector a)] [x (in-vector x)]) (g:+ a (g:* m x)))))
  (values a multipliers))

(define (solve-together who M J f c)
  (define-values (n m) (values (vector-length M) (length J)))
  (define rows
    (for/vector ([k (in-range (+ n m))])
      (if (< k n)
          (vector-append (vector-ref M k)
                         (for/vector ([g (in-list J)]) (g:negate (vector-ref g k))))
          (vector-append (list-ref J (- k n)) (make-vector m 0)))))
  (define x (solve-or-explain who J rows (vector-append f (list->vector c))))
  (values (vector-take x n) (vector-drop x n)))

(define (solve-or-explain who J rows right)
  (with-handlers ([exn:fail:mechanics:singular:matrix?
                   (lambda (e) (raise-undetermined who J e))])
    (rows-solve who rows rows right)))
