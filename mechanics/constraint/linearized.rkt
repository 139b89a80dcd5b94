#lang racket/base
;; What constraints demand of velocities and accelerations, and the forces that keep them.
;;
;; Along a motion with velocity v a constraint G(t, q) = 0 is kept if
;;
;;   ∂₁G v + ∂₀G = 0    and    ∂₁G a + γ = 0,   γ = d²/ds² G(t + s, q + s v),
;;
;; and A(t, q, v) = 0 if ∂₂A a + γ = 0, γ = d/ds A(t + s, q + s v, v), at s = 0.  The
;; *Jacobian* J is ∂₁G or ∂₂A: the motions possible at one time are those that J takes to
;; zero, and the force λ J of a multiplier λ does no work in them.
;;
;; Everything is in rows here: scalars of the coordinates and of the constraints in order.

(require racket/list
         "constraint.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/up-down.rkt"
         "../numeric/linear-algebra/row-matrix.rkt"
         "../value/shape.rkt"
         (only-in "../value/structure.rkt" flip))

(provide constraint-values jacobian-rows drifts force-of-multipliers check-count
         positions-and-velocities rows-of-function)

;; The values, shaped as the multipliers are.
(define (constraint-values who cs t q v)
  (shape-values cs (for/list ([c (in-list (constraint-set-parts cs))]) (value-of who c t q v))))

;; One row of derivatives by the coordinates, or velocities, for each scalar.
(define (jacobian-rows who cs t q v)
  (define (rows c)
    (define (f x) (if (holonomic? c) (value-of who c t x v) (value-of who c t q x)))
    (vector->list (rows-of-function f (if (holonomic? c) q v))))
  (append-map rows (constraint-set-parts cs)))

;; The derivatives of f at x: a row for each scalar of the value.
(define (rows-of-function f x)
  (define (at y) (f (vector->structure x (structure-elements y))))
  (define (flat y) (structure 'up (list->vector (scalars (at y)))))
  (define columns (derivative-at flat (structure 'up (list->vector (scalars x)))))
  (rows-transpose
   (for/vector ([c (in-vector (structure-elements columns))]) (structure-elements c))))

;; γ for each scalar of each constraint, as a list.
(define (drifts who cs t q v)
  (define (drift c) (scalars (last (moved who c t q v (if (holonomic? c) 2 1)))))
  (append-map drift (constraint-set-parts cs)))

;; Two lists with an element for each scalar: the values of the holonomic constraints, #f for
;; others; and for all of them what their time derivative, or value, is in the velocities.
(define (positions-and-velocities who cs t q v)
  (define both
    (for/list ([c (in-list (constraint-set-parts cs))])
      (define rates (and (not (holonomic? c)) (scalars (value-of who c t q v))))
      (if rates
          (list (map (lambda (x) #f) rates) rates)
          (map scalars (moved who c t q v 1)))))
  (values (append-map first both) (append-map second both)))

;; A constraint and its derivatives up to order n at s = 0, the coordinates moving on
;; with velocity v.
(define (moved who c t q v n)
  (derivatives-at (lambda (s) (value-of who c (g:+ t s) (g:+ q (g:* s v)) v)) 0 n))

;; Σ λ J, shaped like a momentum.
(define (force-of-multipliers who cs t q v multipliers)
  (define xs (scalars multipliers))
  (define rows (jacobian-rows who cs t q v))
  (define sums
    (for/vector ([column (in-vector (rows-transpose (list->vector rows)))])
      (for/fold ([sum 0]) ([x (in-list xs)] [g (in-vector column)]) (g:+ sum (g:* x g)))))
  (scalars->structure (flip q) (lambda (k) (vector-ref sums k))))

;; No more constraints than coordinates.
(define (check-count who count q)
  (define n (shape-length q))
  (when (> count n)
    (complain who
              (string-append "there are more constraints than coordinates"
                             "\n  constraints: ~a"
                             "\n  coordinates: ~a, ~a")
              count n (value->text q))))
