#lang racket/base
;; Small oscillations about an equilibrium.
;;
;; Where the force ∂₁L vanishes at rest, a system that starts nearby moves as the
;; second derivatives of L say.  With M = ∂₂∂₂L, K = −∂₁∂₁L and B = ∂₁∂₂L there, the
;; deviation x from the equilibrium obeys
;;
;;   M ẍ + G ẋ + K x = 0,       G = B − Bᵀ,
;;
;; the part of B that is symmetric being a total time derivative.  A normal mode is a
;; solution v e^{iωt}: a null vector v of K − ω²M + iωG.  M and K are symmetric and G is
;; not: its entries are due to turning frames and magnetic fields.

(require "equilibrium.rkt" "argument-order.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/note.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/on-demand.rkt"
         "../generic/up-down.rkt"
         "../hamiltonian/as-Lagrangian.rkt"
         "../lagrangian/Lagrange-equations.rkt"
         "../value/algebra.rkt" "../value/assumptions.rkt"
         "../value/shape.rkt" "../value/simplify.rkt"
         "../value/matrix/linear-algebra.rkt" "../value/matrix/matrix.rkt"
         "../verdict/prove-zero.rkt" "../verdict/question-domain.rkt" "../verdict/verdict.rkt")

(provide mass-matrix stiffness-matrix gyroscopic-matrix
         normal-modes small-oscillation-frequencies
         ;; for stability
         check-autonomous forms)

(require-on-demand ["normal-modes.rkt" modes-of constant-value])

;; ---------------------------------------------------------------------------
;; The linearised equations

;; Each a matrix, or a scalar where q is one.
(define (mass-matrix L q) (second-derivatives 'mass-matrix L q mass-form))
(define (stiffness-matrix L q) (second-derivatives 'stiffness-matrix L q stiffness-form))
(define (gyroscopic-matrix L q) (second-derivatives 'gyroscopic-matrix L q gyroscopic-form))

(define (second-derivatives who L q form)
  (check-order-of-arguments who '(L q) (list L q))
  (check-coordinates who q)
  (form (number-valued who L q) q))

;; The Lagrangian, or that of a Hamiltonian, refusing values that are no numbers
(define (number-valued who given q)
  (define-values (L _none) (as-Lagrangian who given q))
  (scalar-valued who L))

(define (mass-form L q) (form-in-coordinates ((partial 2) ((partial 2) L)) q))
(define (stiffness-form L q) (g:negate (form-in-coordinates ((partial 1) ((partial 1) L)) q)))

(define (gyroscopic-form L q)
  (define B (form-in-coordinates ((partial 1) ((partial 2) L)) q))
  (if (matrix? B) (g:- B (transpose B)) 0))

;; The second derivative at rest as a bilinear form of two displacements.
(define (form-in-coordinates second q)
  (define S (second (at-rest q)))
  (if (tuple? q) (s->m q S q) S))

(define (at-rest q) (up 't q (g:* 0 q)))

;; ---------------------------------------------------------------------------
;; Modes

;; A list of (up frequency shape), slow before fast where all are numbers.
(define (normal-modes L q)
  (for/list ([mode (in-list (modes-at 'normal-modes L q))])
    (up (car mode) (list->structure q (cdr mode)))))

;; The frequencies only.
(define (small-oscillation-frequencies L q)
  (map car (modes-at 'small-oscillation-frequencies L q)))

;; With e^{iωt} goes e^{-iωt}: where ω is not real, one of the two grows.  Roundings may leave an
;; imaginary part beside a real one.
(define (note-growth omegas)
  (define sizes (filter values (map constant-value omegas)))
  (define scale (apply max 0 (map magnitude sizes)))
  (define (rate w) (abs (imag-part w)))
  (define (grows? w) (> (rate w) (if (zero? (real-part w)) 0 (* 1e-7 scale))))
  (define growing (filter grows? sizes))
  (when (pair? growing)
    (note-once
     (format (string-append "a frequency that is not real belongs to no oscillation: this one "
                            "grows as (exp (* ~a t)); the equilibrium is unstable")
             (apply max (map rate growing))))))

;; -> a list of (frequency component ...)
(define (modes-at who given q)
  (check-order-of-arguments who '(L q) (list given q))
  (check-coordinates who q)
  (define L (number-valued who given q))
  (check-equilibrium who L q)
  (define-values (M K G) (forms L q))
  (check-autonomous who L q)
  (define modes (modes-of who M K G))
  (note-growth (map car modes))
  modes)

;; -> the entries of the three matrices, vectors of rows
(define (forms L q)
  (define (entries form)
    (define S (simplify (form L q)))
    (if (matrix? S) (matrix-rows S) (vector (vector S))))
  (values (entries mass-form) (entries stiffness-form) (entries gyroscopic-form)))

;; Rounded coordinates, such as pi, leave a force of the size of rounding.
(define (check-equilibrium who L q)
  (check-value who L q)
  (define force (simplify (((partial 1) L) (at-rest q))))
  (define v (prove-zero force))
  (unless (or (not (refuted? v)) (<= (magnitude (verdict-value v)) 1e-8))
    (complain who
              (string-append "these coordinates are not an equilibrium; at rest there, "
                             "a force remains"
                             "\n  coordinates: ~a"
                             "\n  ∂₁L: ~a")
              (value->text q) (value->text force))))

;; Nothing rests where L has no real value.
(define (check-value who L q)
  (unless (somewhere-real? (domain-expressions (values-along (list L) (at-rest q)))
                           (assumptions-in-force))
    (complain who "the Lagrangian has no real value at these coordinates: ~a" (value->text q))))

;; L must not change in time; nor ∂₂L, for the growth of ∂₁∂₂L in time is a force.
(define (check-autonomous who L q)
  (define t (string->uninterned-symbol "t"))
  (define P ((partial 2) L))
  (define (derivatives t)
    (define state (up t q (g:* 0 q)))
    (up (P state) (((partial 1) P) state) (((partial 2) P) state)
        (((partial 1) ((partial 1) L)) state)))
  (when (refuted? (prove-zero ((D derivatives) t) #:variables (list t)))
    (complain who "the Lagrangian changes in time at these coordinates; ~a"
              "small oscillations are those of a system that does not")))
