#lang racket/base
;; 1/Γ(1 + μ) for |μ| ≤ 1/2, and what Temme's series for Bessel functions need of it.
;;
;; 1/Γ(1 + μ) = Σ dₖ μᵏ (Abramowitz and Stegun, 6.1.34, where cₖ₊₁ = dₖ) converges everywhere.
;; Its odd and even parts are
;;
;;     Γ₁ = (1/Γ(1 − μ) − 1/Γ(1 + μ))/(2μ),    Γ₂ = (1/Γ(1 − μ) + 1/Γ(1 + μ))/2,
;;
;; the first of which would lose its digits near μ = 0 as a difference.

(require racket/flonum)

(provide reciprocal-gammas)

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
