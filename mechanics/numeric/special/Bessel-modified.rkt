#lang racket/base
;; Modified Bessel functions I and K of real order ν ≥ 0 at x > 0.
;;
;; As in Bessel-waves.rkt: I'/I by a continued fraction, down to order μ = ν − m, |μ| ≤ 1/2; K of
;; that and the next order by Steed's continued fraction (Temme 1975, Journal of Computational
;; Physics 19, 324); then I from the Wronskian I K' − K I' = −1/x, and K upwards.  Both are
;; e^(∓x) times numbers of usual size; this factor is put in last.  For x < 2 there are series.

(require racket/flonum racket/math
         "Bessel-series.rkt" "reciprocal-gamma.rkt")

(provide Bessel-I+K)

;; -> I and K of order nu at x, which may be too great or too small: ∞, 0
(define (Bessel-I+K nu x)
  (define m (fl->exact-integer (flfloor (fl+ nu 0.5))))
  (define mu (fl- nu (->fl m)))
  (if (fl< x 2.0) (by-series nu x m mu) (by-fractions nu x m mu)))

(define (by-series nu x m mu)
  (define-values (K next) (Temme-series mu x))
  (values (power-series nu x 1.0) (upwards K next m mu x)))

(define (by-fractions nu x m mu)
  (define ratio (first-fraction nu x))
  (define-values (start here slope) (downwards ratio m nu x))
  (define-values (K next) (Steed-fraction mu x))
  (define K-slope (fl- (fl* (fl/ mu x) K) next))
  (define I (fl/ (fl/ 1.0 x) (fl- (fl* (fl/ slope here) K) K-slope)))
  (define growth (flexp (fl* 0.5 x)))
  (values (fl* growth (fl* growth (fl* start (fl/ I here))))
          (fl/ (fl/ (upwards K next m mu x) growth) growth)))

;; I'/I = ν/x + 1/(2(ν + 1)/x + 1/(2(ν + 2)/x + …)), by Lentz's method
(define (first-fraction nu x)
  (define step (fl/ 2.0 x))
  (define first-one (flmax 1e-300 (fl/ nu x)))
  (let loop ([h first-one] [b (fl* nu step)] [c first-one] [d 0.0])
    (define b* (fl+ b step))
    (define d* (fl/ 1.0 (fl+ b* d)))
    (define c* (fl+ b* (fl/ 1.0 c)))
    (define change (fl* c* d*))
    (if (fl< (flabs (fl- change 1.0)) 1e-16)
        (fl* h change)
        (loop (fl* h change) b* c* d*))))

;; I at ν, and I and I' at μ, in some unit
(define (downwards ratio m nu x)
  (define unit 1e-290)
  (for/fold ([start unit] [I unit] [slope (fl* ratio unit)]) ([k (in-range m)])
    (define up (fl/ (fl- nu (->fl k)) x))
    (define I* (fl+ (fl* up I) slope))
    (define slope* (fl+ (fl* (fl- up (fl/ 1.0 x)) I*) I))
    (if (fl> I* 1e280)
        (values 0.0 (fl* 1e-280 I*) (fl* 1e-280 slope*))
        (values start I* slope*))))

(define (upwards K next m mu x)
  (for/fold ([K K] [next next] #:result K) ([k (in-range 1 (+ m 1))])
    (values next (fl+ (fl* (fl* (fl+ mu (->fl k)) (fl/ 2.0 x)) next) K))))

;; K and K of the next order, for x < 2
(define (Temme-series mu x)
  (define-values (gamma-1 gamma-2 plus minus) (reciprocal-gammas mu))
  (define d (fllog (fl/ 2.0 x)))
  (define e (fl* mu d))
  (define (over sine y) (if (fl< (flabs y) 1e-10) 1.0 (fl/ (sine y) y)))
  (define f0
    (fl/ (fl+ (fl* gamma-1 (cosh e)) (fl* (fl* gamma-2 (over sinh e)) d))
         (over flsin (fl* pi mu))))
  (define p0 (fl/ (fl* 0.5 (flexp e)) plus))
  (define q0 (fl/ (fl* 0.5 (flexp (fl- 0.0 e))) minus))
  (define z (fl* 0.25 (fl* x x)))
  (let loop ([k 1.0] [f f0] [p p0] [q q0] [c 1.0] [sum f0] [sum* p0])
    (define f* (fl/ (fl+ (fl* k f) (fl+ p q)) (fl- (fl* k k) (fl* mu mu))))
    (define c* (fl* c (fl/ z k)))
    (define-values (p* q*) (values (fl/ p (fl- k mu)) (fl/ q (fl+ k mu))))
    (define term (fl* c* f*))
    (define term* (fl* c* (fl- p* (fl* k f*))))
    (if (fl< (flmax (flabs term) (flabs term*)) (fl* 1e-18 (flabs sum)))
        (values sum (fl* (fl/ 2.0 x) sum*))
        (loop (fl+ k 1.0) f* p* q* c* (fl+ sum term) (fl+ sum* term*)))))

;; The same times e^x, for x ≥ 2: with the forward series of z₀, z₁ = … normalized by Temme's sum
;; Σ Cₙ zₙ = (1/2x)^(μ + 1/2)
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
