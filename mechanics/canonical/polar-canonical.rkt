#lang racket/base
;; Canonical transformations that are used again and again (SICM 5.2, pp. 345–346).
;;
;; Polar coordinates of the plane of x and p, with half the square of the radius for momentum:
;;
;;     x = √(2 I/α) sin θ,    p = √(2 I α) cos θ,
;;
;; by which the energy of an oscillator with √(k m) = α is √(k/m) I.  And the centre of mass of
;; two particles with the vector from the first to the second.

(require "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/elementary.rkt"
         "../generic/printed-function.rkt" "../generic/scalar.rkt" "../generic/wrong-argument.rkt"
         "../hamiltonian/H-state.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/shape.rkt" "../value/structure.rkt")

(provide polar-canonical polar-canonical-inverse
         two-particle-center-of-mass two-particle-center-of-mass-canonical)

;; (t, θ, I) ↦ (t, x, p), of one coordinate or of each of several
(define-printed (polar-canonical alpha)
  (check-alpha 'polar-canonical alpha)
  (lambda (state)
    (by-degrees 'polar-canonical state
                (lambda (theta I)
                  (values (g:* (g:sqrt (g:/ (g:* 2 I) alpha)) (g:sin theta))
                          (g:* (g:sqrt (g:* 2 alpha I)) (g:cos theta)))))))

;; (t, x, p) ↦ (t, θ, I)
(define-printed (polar-canonical-inverse alpha)
  (check-alpha 'polar-canonical-inverse alpha)
  (lambda (state)
    (by-degrees 'polar-canonical-inverse state
                (lambda (x p)
                  (values (g:atan (g:* alpha x) p)
                          (g:* 1/2 (g:+ (g:* alpha (g:square x))
                                        (g:/ (g:square p) alpha))))))))

;; f : coordinate and momentum -> coordinate and momentum
(define (by-degrees who state f)
  (check-H-state who state)
  (define-values (qs ps)
    (for/lists (qs ps) ([q (in-list (scalars (coordinate state)))]
                        [p (in-list (scalars (momentum state)))])
      (f q p)))
  (up (time state)
      (list->structure (coordinate state) qs)
      (list->structure (momentum state) ps)))

(define (check-parameter who what x)
  (unless (scalar? x)
    (complain who "~a is a number or a symbol; given ~a~a" what (describe-with-value x)
              (if (H-state? x) "\n  was a parameter left out? the state comes after it" ""))))

;; The roots of a number that is not positive are imaginary.
(define (check-alpha who alpha)
  (check-parameter who "alpha" alpha)
  (define a (comparand alpha))
  (when (and (number? a) (not (and (real? a) (< 0 a +inf.0))))
    (complain who "alpha is positive; given ~a" (describe-with-value alpha))))

;; ---------------------------------------------------------------------------
;; Two particles

;; state with (up x₁ x₂) ↦ (up X x), the centre of mass and x₂ − x₁
(define-printed (two-particle-center-of-mass m1 m2)
  (define who 'two-particle-center-of-mass)
  (for ([m (in-list (list m1 m2))]) (check-parameter who "a mass" m))
  (lambda (state)
    (define-values (x1 x2) (two who (coordinate state)))
    (up (g:/ (g:+ (g:* m1 x1) (g:* m2 x2)) (g:+ m1 m2))
        (g:- x2 x1))))

;; The same with the momenta: p₁ + p₂, and (m₁ p₂ − m₂ p₁)/(m₁ + m₂)
(define-printed (two-particle-center-of-mass-canonical m1 m2)
  (define who 'two-particle-center-of-mass-canonical)
  (for ([m (in-list (list m1 m2))]) (check-parameter who "a mass" m))
  (define positions (two-particle-center-of-mass m1 m2))
  (lambda (state)
    (check-H-state who state)
    (define-values (p1 p2) (two who (momentum state)))
    (up (time state)
        (positions state)
        (down (g:+ p1 p2)
              (g:/ (g:- (g:* m1 p2) (g:* m2 p1)) (g:+ m1 m2))))))

(define (two who x)
  (unless (and (tuple? x) (= (s:length x) 2))
    (complain-of-argument who "the state of two particles, (up t (up x1 x2) (down p1 p2))" x))
  (values (s:ref x 0) (s:ref x 1)))
