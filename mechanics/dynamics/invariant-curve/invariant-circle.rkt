#lang racket/base
;; Invariant circles of maps that keep areas, by Newton's method in Fourier space.
;;
;; Wanted is a closed curve k(θ) on which the map T is the rotation by ω,
;;
;;     T(k(θ)) = k(θ + ω).
;;
;; Of a curve that misses this by e(θ), the tangent α = k' and β = (−α₂, α₁)/|α|² make a frame of
;; area 1, in which the derivative of T is a shear but for terms as small as e:
;;
;;     DT α = α₊,    DT β = S α₊ + β₊,    S = det(DT β, β₊),    f₊(θ) = f(θ + ω).
;;
;; So the correction ξα + ζβ solves, with (η, κ) the components of −e in the frame at θ + ω,
;;
;;     ξ − ξ₊ + S ζ = η,     ζ − ζ₊ = κ,
;;
;; two equations that are solved term by term in Fourier series; the mean of ζ is the one for
;; which the first one can be (de la Llave, González, Jorba and Villanueva 2005).  Each step
;; squares the error.

(require racket/flonum
         "circle-equation.rkt" "invariant-curve.rkt" "../map/jacobian.rkt"
         "../map/map-of-the-plane.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt"
         "../../generic/define-plain.rkt" "../../generic/number-argument.rkt"
         "../../generic/up-down.rkt" "../../generic/value-struct.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt" "../../numeric/periodic-function.rkt")

(provide invariant-circle invariant-circle? invariant-circle-ordinate
         ;; for their limits
         circle-for)

;; x, y : (angle -> value): the curve is (θ + x(θ), y(θ)); modes : terms of its Fourier series
;; error : the greatest |T(k(θ)) − k(θ + ω)| where it was computed
(value-struct circle (rotation x y modes error)
  #:text circle->text
  #:property prop:procedure (lambda (c theta) (point-at c theta)))

(define (invariant-circle? x) (circle? x))

(define a-circle "a circle, as invariant-circle finds one")
(provide-parts circle? a-circle invariant-circle-error invariant-circle-modes)
(define invariant-circle-error circle-error)
(define invariant-circle-modes circle-modes)

(define (point-at c angle)
  (define theta (flonum 'invariant-circle angle))
  (up (fl+ theta ((circle-x c) theta)) ((circle-y c) theta)))

(define (flonum who x) (real->double-flonum (finite-number who x)))

;; The ordinate of the circle at an abscissa, by the secant method.
(define (invariant-circle-ordinate c abscissa)
  (check-argument 'invariant-circle-ordinate circle? c a-circle)
  (define x (flonum 'invariant-circle-ordinate abscissa))
  (define (miss theta) (fl- (fl+ theta ((circle-x c) theta)) x))
  (let loop ([a (fl- x 1e-3)] [at-a (miss (fl- x 1e-3))] [b x] [at-b (miss x)] [n 0])
    (if (or (fl<= (flabs at-b) 4e-16) (fl= at-a at-b) (= n 60))
        ((circle-y c) b)
        (let ([next (fl- b (fl* at-b (fl/ (fl- b a) (fl- at-b at-a))))])
          (loop b at-b next (miss next) (+ n 1))))))

(define (circle->text c)
  (format "invariant circle with rotation number ~a\n  residual: ~a, with ~a terms"
          (circle-rotation c) (circle-error c) (circle-modes c)))

;; ---------------------------------------------------------------------------
;; Finding one

;; The residual that rounding leaves of a map that is computed to rounding.
(define small 1e-14)

;; The same with the greatest number of terms, each of which adds to the rounding.
(define small-at-last 1e-12)

;; A residual below this, which twice as many terms hardly improve, is the error of the map itself,
;; as that of an integrated motion.
(define plausible 1e-9)

;; Below this residual the next search with more terms starts from the curve, else from the orbit.
(define worth-refining 1e-5)

;; An orbit of many thousand points leaves gaps of some 0.05 on a circle that is about to break up,
;; and of half a turn where it wanders about.
(define widest-gap 0.5)

;; low, high : ordinates at the angle 0, with the circle between them
(define-plain (invariant-circle map rotation-number #:from [low #f] #:to [high #f]
                                #:most-modes [most 4096])
  (circle-for 'invariant-circle map rotation-number low high most))

(define (circle-for who map rotation-number given-low given-high most)
  (check-map who map rotation-number)
  (check-argument who exact-positive-integer? most "#:most-modes, a positive integer")
  (define rotation (flonum who rotation-number))
  (define omega (fl* :2pi rotation))
  (define-values (low high) (ends who given-low given-high omega))
  (check-keeps-areas who map (list (list 0.1 low) (list 1.0 omega) (list 4.0 high))
                     "invariant circles")
  (check-irrational who rotation)
  (define J (flonum who (curve-between who map rotation 0 low high 1e-9 between-hint)))
  (define equation (circle-equation who map J omega))
  (define-values (orbit gap) (curve-of-orbit map J omega))
  (when (fl> gap widest-gap) (raise-chaotic who rotation J))
  (define (found x y error)
    (circle rotation (periodic-value-at x) (periodic-value-at y)
            (quotient (flvector-length x) 2) error))
  (let refine ([n 128] [before-x #f] [before-y #f] [before +inf.0])
    (define-values (start-x start-y)
      (if (fl< before worth-refining) (both-refined before-x before-y) (orbit n)))
    (define-values (x y error) (solve-circle equation start-x start-y))
    (define last? (>= (quotient n 2) most))
    (cond [(fl< error (if last? small-at-last small)) (found x y error)]
          [(and (fl< before plausible) (fl> error (fl* 0.25 before)))
           (if (fl< error before) (found x y error) (found before-x before-y before))]
          [last? (raise-none who rotation error (quotient n 2))]
          [else (refine (* 2 n) x y error)])))

(define between-hint
  "\n  #:from and #:to say between which ordinates it is, at the abscissa 0")

;; A map that brings ordinates back to one turn turns by less than one.
(define (turns-hint rotation)
  (format "\n  where ordinates come back by whole turns, ~a is the same rotation"
          (fl- rotation (flfloor rotation))))

(define (raise-none who rotation error modes)
  (raise-not-convergent who
                        (string-append "no smooth invariant circle was found with so many terms; "
                                       "it may have broken up"
                                       (if (fl<= 0.0 rotation 1.0) "" (turns-hint rotation)))
                        #f error #:show? #f
                        "rotation number" rotation "residual" error "terms" modes))

;; Newton's method would find nothing, which takes minutes where the map is that of a motion.
(define (raise-chaotic who rotation J)
  (raise-not-convergent who
                        (string-append "no invariant circle was found: the orbit that turns most "
                                       "like it lies on no curve,\n  as where the motion is "
                                       "chaotic; it may have broken up")
                        #f #f #:show? #f
                        "rotation number" rotation "start of the orbit" (up 0.0 J)))

;; On a circle whose rotation number is a fraction all orbits would be periodic; of such circles a
;; map keeps none but those that it turns like a rotation.
(define (check-irrational who rotation)
  (define fraction (rationalize (inexact->exact rotation) 1/1000000000000))
  (when (<= (denominator fraction) 100)
    (complain who
              (string-append "a circle that is kept has an irrational rotation number; this is ~a"
                             "\n  given: ~a\n  (periodic-points map ~a region) finds what is left of "
                             "such a circle")
              fraction rotation (denominator fraction))))

;; Where actions are the angles by which they turn, as in the standard map, half a radian on both
;; sides of the rotation's is usually enough.
(define (ends who low high omega)
  (values (if low (flonum who low) (fl- omega 0.5))
          (if high (flonum who high) (fl+ omega 0.5))))
