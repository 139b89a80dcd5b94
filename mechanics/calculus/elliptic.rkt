#lang racket/base
;; Elliptic integrals and Jacobi's elliptic functions, of the modulus k, |k| < 1
;; (Abramowitz and Stegun, ch. 17 and 16; Carlson 1979).
;;
;; The arithmetic-geometric mean of 1 and k' = √(1 − k²),
;;
;;     a ← (a + b)/2,  b ← √(ab),  c ← (a − b)/2,
;;
;; leads to K = π/2a and E = K (1 − Σ 2ⁿ⁻¹ cₙ²), where c₀ = k, and with the angles
;; φₙ = 2ⁿ a u, φₙ₋₁ = (φₙ + asin(cₙ sin φₙ/aₙ))/2 to sn u = sin φ₀ and
;; cn u = cos φ₀.  Each step squares the relative difference of a and b.  Since it is
;; all arithmetic, derivatives pass through it.
;;
;; Incomplete integrals are Carlson's, and that of the third kind.  Their derivatives are those
;; of the integrals that define them.  They are real for |k| ≥ 1, too, up to |k sin φ| = 1.

(require "perturbed-value.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/elementary.rkt" "../generic/kind.rkt"
         "../generic/number-argument.rkt" "../generic/on-demand.rkt" "../generic/rounding.rkt"
         "../generic/wrong-argument.rkt"
         "../numeric/constants.rkt"
         (prefix-in carlson: "../numeric/special/elliptic-integrals.rkt"))

(provide first-elliptic-integral second-elliptic-integral elliptic-integrals
         third-elliptic-integral
         elliptic-integral-F elliptic-integral-E elliptic-integral-Pi
         Jacobi-elliptic-functions)

(require-on-demand ["integral.rkt" integrate])

;; From b = 1e-300 on it takes 12 steps to rounding, 9 from 1e-8.
(define steps 12)

;; -> lists of a and c, from the last to the first
(define (means k)
  (for/fold ([as '(1.0)] [b (g:sqrt (g:* (g:- 1.0 k) (g:+ 1.0 k)))] [cs (list k)]
             #:result (values as cs))
            ([_ (in-range steps)])
    (define a (car as))
    (values (cons (g:* 0.5 (g:+ a b)) as)
            (g:sqrt (g:* a b))
            (cons (g:* 0.5 (g:- a b)) cs))))

;; ---------------------------------------------------------------------------
;; Complete integrals

(define (first-elliptic-integral given)
  (define k (modulus 'first-elliptic-integral given))
  (define-values (as cs) (means k))
  (g:/ :pi/2 (car as)))

(define (second-elliptic-integral given)
  (cond [(and (real? given) (= (abs given) 1)) 1.0]
        [else
         (define k (modulus 'second-elliptic-integral given))
         (define-values (K E) (both k))
         E]))

;; Π(n, k), of a characteristic below 1
(define (third-elliptic-integral n k)
  (check-modulus 'third-elliptic-integral k)
  (define who 'third-elliptic-integral)
  (unless (< (number-beneath who n) 1)
    (complain-of-argument who
                          (string-append "a characteristic below 1, from where on the integral "
                                         "does not converge")
                          n))
  (pi-integral who n :pi/2 k))

;; (receive K E)
(define (elliptic-integrals given receive)
  (define k (modulus 'elliptic-integrals given))
  (call-with-values (lambda () (both k)) receive))

(define (both k)
  (define-values (as cs) (means k))
  (define K (g:/ :pi/2 (car as)))
  (define sum
    (for/fold ([sum 0.0]) ([c (in-list (reverse cs))] [n (in-naturals)])
      (g:+ sum (g:* (expt 2.0 (- n 1)) c c))))
  (values K (g:* K (g:- 1.0 sum))))

;; ---------------------------------------------------------------------------
;; Incomplete integrals

(define (elliptic-integral-F phi k)
  (incomplete 'elliptic-integral-F carlson:F phi k
              (lambda (s k) (g:/ 1 (g:sqrt (g:- 1 (g:square (g:* k (g:sin s)))))))))

(define (elliptic-integral-E phi k)
  (incomplete 'elliptic-integral-E carlson:E phi k
              (lambda (s k) (g:sqrt (g:- 1 (g:square (g:* k (g:sin s))))))))

(define (elliptic-integral-Pi n phi k)
  (define who 'elliptic-integral-Pi)
  (check-incomplete who (number-beneath who phi) (number-beneath who k) <)
  (check-characteristic who (number-beneath who n) (number-beneath who phi))
  (pi-integral who n phi k))

;; ∫ dθ/((1 − n sin² θ) √(1 − k² sin² θ))
(define (pi-integral who given-n given-phi given-k)
  (define-values (n phi k)
    (values (in-flonums given-n) (in-flonums given-phi) (in-flonums given-k)))
  (define (integrand s)
    (define square (g:square (g:sin s)))
    (g:/ 1 (g:* (g:- 1 (g:* n square)) (g:sqrt (g:- 1 (g:* (g:square k) square))))))
  (if (ormap perturbed? (list n phi k))
      (integrate who integrand 0 phi 1e-13)
      (apply carlson:Pi
             (for/list ([x (in-list (list n phi k))]) (real->double-flonum (number who x))))))

(define (incomplete who value given-phi given-k integrand)
  (define k (in-flonums given-k))
  (define phi (in-flonums given-phi))
  (check-incomplete who (number-beneath who phi) (number-beneath who k)
                    (if (eq? value carlson:E) <= <))
  (if (or (perturbed? phi) (perturbed? k))
      (integrate who (lambda (s) (integrand s k)) 0 phi 1e-13)
      (value (real->double-flonum (number who phi)) (real->double-flonum k))))

;; ---------------------------------------------------------------------------
;; Jacobi's functions

;; (receive (sn u) (cn u) (dn u))
(define (Jacobi-elliptic-functions given-u given-k receive)
  (define k (modulus 'Jacobi-elliptic-functions given-k))
  (define u (in-flonums given-u))
  (unless (perturbed? u) (number 'Jacobi-elliptic-functions u))
  (define-values (as cs) (means k))
  (define phi
    (for/fold ([phi (g:* (expt 2.0 steps) (car as) u)])
              ([a (in-list as)] [c (in-list cs)] [_ (in-range steps)])
      (g:* 0.5 (g:+ phi (g:asin (g:/ (g:* c (g:sin phi)) a))))))
  (define-values (sn cn) (values (g:sin phi) (g:cos phi)))
  ;; 1 − k² sn² without a difference, which near 0 would leave few digits
  (define complement (g:* (g:- 1.0 k) (g:+ 1.0 k)))
  (receive sn cn (g:sqrt (g:+ (g:square cn) (g:* complement (g:square sn))))))

;; ---------------------------------------------------------------------------

;; k, checked
(define (modulus who k)
  (check-modulus who k)
  (in-flonums k))

;; More digits would be shown than are right.
(define (in-flonums x)
  (if (other-number? (innermost x)) (g:exact->inexact x) x))

;; Up to k sin φ = 1 or little more, by rounding; but F is infinite at π/2 for k = 1.
;; below : < or <=, how the modulus must be to 1 for any angle
(define (check-incomplete who phi k below)
  (define reach (abs (* k (sin phi))))
  (unless (or (below (abs k) 1)
              (and (<= (abs phi) :pi/2)
                   (<= reach (+ 1 4e-16))
                   (not (and (= (abs k) 1) (= reach 1)))))
    (complain who
              (string-append "expected a modulus k between -1 and 1, or one with |k sin φ| <= 1 "
                             "up to φ; given the modulus ~a and the angle ~a")
              k phi)))

;; 1 − n sin² θ is not 0 on the way.
(define (check-characteristic who n phi)
  (define greatest (if (> (abs phi) :pi/2) 1.0 (sin phi)))
  (unless (< (* n greatest greatest) 1)
    (complain who
              (string-append "expected a characteristic n with n sin² φ < 1 up to φ, for the "
                             "integral does not converge beyond; given ~a and the angle ~a")
              n phi)))

(define (check-modulus who k)
  (unless (< -1 (number-beneath who k) 1)
    (complain-of-argument who "a modulus between -1 and 1" k)))
