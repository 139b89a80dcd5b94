#lang racket/base
;; Modified Bessel functions I and K of real order ν ≥ 0 at x > 0.
;;
;; As in Bessel-waves.rkt: I'/I by a continued fraction, down to order μ = ν − m, |μ| ≤ 1/2; K of
;; that and the next order by Steed's continued fraction (Temme 1975, Journal of Computational
;; Physics 19, 324); then I from the Wronskian I K' − K I' = −1/x, and K upwards.  Both are
;; e^(∓x) times numbers of usual size; this factor is put in last.  For x < 2 there are series.

(require racket/flonum racket/math
         "Bessel-recurrences.rkt" "Bessel-series.rkt")

(provide Bessel-I+K)

;; -> I and K of order nu at x, which may be too great or too small: ∞, 0
(define (Bessel-I+K nu x)
  (define-values (m mu) (nearest-order nu))
  (if (fl< x 2.0) (by-series nu x m mu) (by-fractions nu x m mu)))

(define (by-series nu x m mu)
  (define-values (K next) (Temme-series mu x 1.0))
  (values (power-series nu x 1.0) (upwards K next m mu x 1.0)))

(define (by-fractions nu x m mu)
  (define-values (ratio side) (first-fraction nu x 1.0))
  (define-values (start here slope) (downwards ratio side m nu x 1.0))
  (define-values (K next) (Steed-fraction mu x))
  (define K-slope (fl- (fl* (fl/ mu x) K) next))
  (define I (fl/ (fl/ 1.0 x) (fl- (fl* (fl/ slope here) K) K-slope)))
  (define growth (flexp (fl* 0.5 x)))
  (values (fl* growth (fl* growth (fl* start (fl/ I here))))
          (fl/ (fl/ (upwards K next m mu x 1.0) growth) growth)))

;; K and K of the next order, both times e^x, for x ≥ 2: with the forward series of z₀, z₁ = …
;; normalized by Temme's sum Σ Cₙ zₙ = (1/2x)^(μ + 1/2)
(define (Steed-fraction mu x)
  (define a1 (fl- 0.25 (fl* mu mu)))
  (define b1 (fl* 2.0 (fl+ 1.0 x)))
  (define d1 (fl/ 1.0 b1))
  (define-values (h s)
    (let loop ([i 2.0] [a (fl- 0.0 a1)] [b b1] [c a1] [d d1] [change d1] [h d1]
               [q1 0.0] [q2 1.0] [q a1] [s (fl+ 1.0 (fl* a1 d1))])
      (define a* (fl- a (fl* 2.0 (fl- i 1.0))))
      (define c* (fl/ (fl* (fl- 0.0 a*) c) i))
      (define new (fl/ (fl- q1 (fl* b q2)) a*))
      (define q* (fl+ q (fl* c* new)))
      (define b* (fl+ b 2.0))
      (define d* (fl/ 1.0 (fl+ b* (fl* a* d))))
      (define change* (fl* (fl- (fl* b* d*) 1.0) change))
      (define h* (fl+ h change*))
      (define term (fl* q* change*))
      (define s* (fl+ s term))
      (if (or (fl= a1 0.0) (fl< (flabs (fl/ term s*)) 1e-17) (fl> i 1e4))
          (values (fl* a1 h*) s*)
          (loop (fl+ i 1.0) a* b* c* d* change* h* q2 new q* s*))))
  (define K (fl/ (flsqrt (fl/ pi (fl* 2.0 x))) s))
  (values K (fl* K (fl/ (fl- (fl+ mu (fl+ x 0.5)) h) x))))
