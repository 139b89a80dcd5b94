#lang racket/base
;; Bessel functions of real order near x = 0, by series in z = ±x²/4: − for J and Y, + for I and K.
;;
;;     J, I = (x/2)^ν/Γ(ν + 1) Σ zᵏ/(k! (ν + 1) … (ν + k)).
;;
;; K, and Y but for the factor −2/π, are Σ cₖ gₖ and of the next order 2/x Σ cₖ hₖ, where cₖ = zᵏ/k!
;; (N. M. Temme, Journal of Computational Physics 19, 1975, 324, and 21, 1976, 343).  Both take
;; 1/Γ(1 + μ) = Σ dₖ μᵏ, |μ| ≤ 1/2 (Abramowitz and Stegun, 6.1.34, where cₖ₊₁ = dₖ), whose odd and
;; even parts are
;;
;;     Γ₁ = (1/Γ(1 − μ) − 1/Γ(1 + μ))/(2μ),    Γ₂ = (1/Γ(1 − μ) + 1/Γ(1 + μ))/2;
;;
;; as a difference the first would lose its digits near μ = 0.

(require racket/flonum racket/math)

(provide nearest-order power-series Temme-series)

;; The order ν as m + μ, |μ| ≤ 1/2 -> m, μ
(define (nearest-order nu)
  (define m (fl->exact-integer (flfloor (fl+ nu 0.5))))
  (values m (fl- nu (->fl m))))

;; -> J, if the sign of z is −1.0, or I, if it is 1.0
(define (power-series nu x sign)
  (define-values (m mu) (nearest-order nu))
  (define-values (gamma-1 gamma-2 plus minus) (reciprocal-gammas mu))
  (define scale
    (for/fold ([scale (fl* (fl* (flexpt x mu) (flexpt 0.5 mu)) plus)]) ([k (in-range 1 (+ m 1))])
      (fl/ (fl* scale x) (fl* 2.0 (fl+ mu (->fl k))))))
  (define z (fl* sign (fl* 0.25 (fl* x x))))
  (let loop ([k 1.0] [term 1.0] [sum 1.0])
    (define next (fl* term (fl/ z (fl* k (fl+ nu k)))))
    (if (fl< (flabs next) 1e-18)
        (fl* scale sum)
        (loop (fl+ k 1.0) next (fl+ sum next)))))

;; -> K, or −π/2 Y if the sign of z is −1.0, of order mu and of the next one, for x < 2
(define (Temme-series mu x sign)
  (define-values (gamma-1 gamma-2 plus minus) (reciprocal-gammas mu))
  (define angle (fl* pi mu))
  (define d (fl- (fllog 2.0) (fllog x)))
  (define e (fl* mu d))
  (define (over sine y) (if (fl< (flabs y) 1e-10) 1.0 (fl/ (sine y) y)))
  (define half (over flsin (fl* 0.5 angle)))
  (define r (if (fl< sign 0.0) (fl* (fl* pi angle) (fl* 0.5 (fl* half half))) 0.0))
  (define f0
    (fl/ (fl+ (fl* gamma-1 (cosh e)) (fl* (fl* gamma-2 (over sinh e)) d))
         (over flsin angle)))
  (define p0 (fl/ (fl* 0.5 (flexp e)) plus))
  (define q0 (fl/ (fl* 0.5 (flexp (fl- 0.0 e))) minus))
  (define z (fl* sign (fl* 0.25 (fl* x x))))
  (let loop ([k 1.0] [f f0] [p p0] [q q0] [c 1.0] [sum (fl+ f0 (fl* r q0))] [sum* p0])
    (define f* (fl/ (fl+ (fl* k f) (fl+ p q)) (fl- (fl* k k) (fl* mu mu))))
    (define c* (fl* c (fl/ z k)))
    (define-values (p* q*) (values (fl/ p (fl- k mu)) (fl/ q (fl+ k mu))))
    (define g (fl+ f* (fl* r q*)))
    (define term (fl* c* g))
    (define term* (fl* c* (fl- p* (fl* k g))))
    (if (and (fl<= (flabs term) (fl* 1e-17 (flabs sum)))
             (fl<= (flabs term*) (fl* 1e-17 (flabs sum*))))
        (values sum (fl/ (fl* 2.0 sum*) x))
        (loop (fl+ k 1.0) f* p* q* c* (fl+ sum term) (fl+ sum* term*)))))

;; ---------------------------------------------------------------------------

(define coefficients
  (flvector
   1.0 0.57721566490153286061 -0.65587807152025388108 -0.042002635034095235529
   0.1665386113822914895 -0.042197734555544336748 -0.0096219715278769735621
   0.0072189432466630995424 -0.0011651675918590651121 -0.00021524167411495097282
   0.00012805028238811618615 -0.000020134854780788238656 -1.2504934821426706573e-6
   1.1330272319816958824e-6 -2.0563384169776071035e-7 6.1160951044814158179e-9
   5.0020076444692229301e-9 -1.1812745704870201446e-9 1.0434267116911005105e-10
   7.782263439905071254e-12 -3.6968056186422057082e-12 5.100370287454475979e-13
   -2.0583260535665067832e-14 -5.3481225394230179824e-15))

;; -> Γ₁, Γ₂, 1/Γ(1 + μ), 1/Γ(1 − μ)
(define (reciprocal-gammas mu)
  (define square (fl* mu mu))
  (define (sum from)
    (for/fold ([sum 0.0]) ([k (in-range (+ 22 from) -1 -2)])
      (fl+ (flvector-ref coefficients k) (fl* square sum))))
  (define gamma-1 (fl- 0.0 (sum 1)))
  (define gamma-2 (sum 0))
  (values gamma-1
          gamma-2
          (fl- gamma-2 (fl* mu gamma-1))
          (fl+ gamma-2 (fl* mu gamma-1))))
