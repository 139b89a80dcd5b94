#lang racket/base
;; Canonical transformations that are used again and again (SICM 5.2, pp. 345–346).
;;
;; Polar coordinates of the plane of x and p, with half the square of the radius for momentum:
;;
;;     x = √(2 I/α) sin θ,    p = √(2 I α) cos θ,
;;
;; by which the energy of an oscillator with √(k m) = α is √(k/m) I.  And the centre of mass of
;; two particles with what leads from the first to the second.

(require "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/elementary.rkt"
         "../generic/function.rkt" "../generic/scalar.rkt" "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/structure.rkt")

(provide polar-canonical polar-canonical-inverse
         two-particle-center-of-mass two-particle-center-of-mass-canonical)

;; (t, θ, I) ↦ (t, x, p), of one coordinate or of each of several
(define (polar-canonical alpha)
  (check-parameter 'polar-canonical "alpha" alpha)
  (check-positive 'polar-canonical alpha)
  (unary-function (lambda () (list 'polar-canonical (value->datum alpha))) (state)
    (by-degrees 'polar-canonical state
                (lambda (theta I)
                  (values (g:* (g:sqrt (g:/ (g:* 2 I) alpha)) (g:sin theta))
                          (g:* (g:sqrt (g:* 2 alpha I)) (g:cos theta)))))))

;; (t, x, p) ↦ (t, θ, I)
(define (polar-canonical-inverse alpha)
  (check-parameter 'polar-canonical-inverse "alpha" alpha)
  (check-positive 'polar-canonical-inverse alpha)
  (unary-function (lambda () (list 'polar-canonical-inverse (value->datum alpha))) (state)
    (by-degrees 'polar-canonical-inverse state
                (lambda (x p)
                  (values (g:atan (g:* alpha x) p)
                          (g:* 1/2 (g:+ (g:* alpha (g:square x))
                                        (g:/ (g:square p) alpha))))))))

;; f : coordinate and momentum -> coordinate and momentum
(define (by-degrees who state f)
  (check-H-state who state)
  (define-values (q p)
    (let walk ([q (coordinate state)] [p (momentum state)])
      (cond [(scalar? q) (f q p)]
            [else
             (define pairs
               (for/list ([a (in-vector (tuple-elements q))] [b (in-vector (tuple-elements p))])
                 (call-with-values (lambda () (walk a b)) cons)))
             (values (list->structure-like q (map car pairs))
                     (list->structure-like p (map cdr pairs)))])))
  (up (time state) q p))

(define (check-parameter who what x)
  (unless (scalar? x)
    (complain who "~a is a number or a symbol; given ~a~a" what (describe-with-value x)
              (if (H-state? x) "\n  was a parameter left out? the state comes after it" ""))))

;; Of another number the roots are imaginary.
(define (check-positive who alpha)
  (define a (comparand alpha))
  (when (and (number? a) (not (and (real? a) (< 0 a +inf.0))))
    (complain who "alpha is positive; given ~a" (describe-with-value alpha))))

(define (list->structure-like s xs) (same-orientation (adopt s) (list->vector xs)))

;; ---------------------------------------------------------------------------
;; Two particles

;; state with (up x₁ x₂) ↦ (up X x), the centre of mass and x₂ − x₁
(define (two-particle-center-of-mass m1 m2)
  (define who 'two-particle-center-of-mass)
  (check-parameter who "a mass" m1)
  (check-parameter who "a mass" m2)
  (unary-function (lambda () (list who (value->datum m1) (value->datum m2))) (state)
    (define-values (x1 x2) (two who (coordinate state)))
    (up (g:/ (g:+ (g:* m1 x1) (g:* m2 x2)) (g:+ m1 m2))
        (g:- x2 x1))))

;; The same with the momenta: p₁ + p₂, and (m₁ p₂ − m₂ p₁)/(m₁ + m₂)
(define (two-particle-center-of-mass-canonical m1 m2)
  (define who 'two-particle-center-of-mass-canonical)
  (check-parameter who "a mass" m1)
  (check-parameter who "a mass" m2)
  (define positions (two-particle-center-of-mass m1 m2))
  (unary-function (lambda () (list who (value->datum m1) (value->datum m2))) (state)
    (check-H-state who state)
    (define-values (p1 p2) (two who (momentum state)))
    (up (time state)
        (positions state)
        (down (g:+ p1 p2)
              (g:/ (g:- (g:* m1 p2) (g:* m2 p1)) (g:+ m1 m2))))))

(define (two who x)
  (unless (and (tuple? x) (= (structure-length (adopt x)) 2))
    (complain who "expected the state of two particles, (up t (up x1 x2) (down p1 p2)); given ~a"
              (describe-with-value x)))
  (values (s:ref x 0) (s:ref x 1)))
