#lang racket/base
;; Demands of constraints on velocities and accelerations, and the forces that keep them.
;;
;; Along a motion with velocity v a constraint G(t, q) = 0 is kept if
;;
;;   ∂₁G v + ∂₀G = 0    and    ∂₁G a + γ = 0,   γ = d²/ds² G(t + s, q + s v),
;;
;; and A(t, q, v) = 0 if ∂₂A a + γ = 0, γ = d/ds A(t + s, q + s v, v), at s = 0.  The
;; *Jacobian* J is ∂₁G or ∂₂A: the motions possible at one time are those that J takes to
;; zero, and the force λ J of a multiplier λ does no work in them.
;;
;; Derivatives are in rows: one entry for each scalar of the coordinates, one row for each of the
;; constraints, in order.

(require racket/list
         "constraint.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/up-down.rkt"
         "../lagrangian/local-tuple.rkt"
         "../numeric/linear-algebra/row-matrix.rkt"
         "../value/shape.rkt" (only-in "../value/structure.rkt" flip list->up)
         "../value/matrix/row-products.rkt")

(provide constraint-values checked-constraint-values
         jacobian-rows drifts force-of-multipliers check-count
         positions-and-velocities rows-of-function)

;; The values at a state, shaped as the multipliers are.
(define (constraint-values who cs state)
  (define-values (t q v) (state-parts state))
  (shape-values cs (for/list ([c (in-list (constraint-set-parts cs))]) (value-of who c t q v))))

;; The same; nonholonomic constraints must be linear in the velocities, and all together no more
;; than the coordinates.
(define (checked-constraint-values who cs state)
  (define q (coordinate state))
  (check-linear who cs q)
  (define values (constraint-values who cs state))
  (check-count who (shape-length values) q)
  values)

;; One row of derivatives by the coordinates, or velocities, for each scalar.
(define (jacobian-rows who cs state)
  (define-values (t q v) (state-parts state))
  (define (rows c)
    (define (f x) (if (holonomic? c) (value-of who c t x v) (value-of who c t q x)))
    (vector->list (rows-of-function f (if (holonomic? c) q v))))
  (append-map rows (constraint-set-parts cs)))

;; The derivatives of f at x: a row for each scalar of the value.
(define (rows-of-function f x)
  (define (at y) (f (vector->structure x (structure-elements y))))
  (define (flat y) (list->up (scalars (at y))))
  (define columns (derivative-at flat (list->up (scalars x))))
  (rows-transpose
   (for/vector ([c (in-vector (structure-elements columns))]) (structure-elements c))))

;; γ for each scalar of each constraint, as a list.
(define (drifts who cs state)
  (define (drift c) (scalars (last (moved who c state (if (holonomic? c) 2 1)))))
  (append-map drift (constraint-set-parts cs)))

;; -> two lists with an element for each scalar: the values of the holonomic constraints, #f for
;; others; and the time derivatives of the holonomic ones, the values of the others.
(define (positions-and-velocities who cs state)
  (define-values (t q v) (state-parts state))
  (define both
    (for/list ([c (in-list (constraint-set-parts cs))])
      (define rates (and (not (holonomic? c)) (scalars (value-of who c t q v))))
      (if rates
          (list (map (lambda (x) #f) rates) rates)
          (map scalars (moved who c state 1)))))
  (values (append-map first both) (append-map second both)))

;; A constraint and its derivatives up to order n at s = 0, the coordinates moving on
;; with velocity v.
(define (moved who c state n)
  (define-values (t q v) (state-parts state))
  (derivatives-at (lambda (s) (value-of who c (g:+ t s) (g:+ q (g:* s v)) v)) 0 n))

;; Σ λ J, shaped like a momentum.
(define (force-of-multipliers who cs state multipliers)
  (define xs (list->vector (scalars multipliers)))
  (define columns (rows-transpose (list->vector (jacobian-rows who cs state))))
  (vector->structure (flip (coordinate state))
                     (for/vector ([column (in-vector columns)]) (sum-of-products xs column))))

;; No more constraints than coordinates.
(define (check-count who count q)
  (define n (shape-length q))
  (when (> count n)
    (complain who
              (string-append "there are more constraints than coordinates"
                             "\n  constraints: ~a"
                             "\n  coordinates: ~a, ~a")
              count n (value->text q))))
