#lang racket/base
;; The power series of J and I of order ν ≥ 0, for small x > 0:
;;
;;     (x/2)^ν/Γ(ν + 1) Σ (±x²/4)ᵏ/(k! (ν + 1) … (ν + k)).

(require racket/flonum
         "reciprocal-gamma.rkt")

(provide power-series)

;; sign : −1.0 for J, 1.0 for I
(define (power-series nu x sign)
  (define m (fl->exact-integer (flfloor (fl+ nu 0.5))))
  (define mu (fl- nu (->fl m)))
  (define half (fl* 0.5 x))
  (define-values (gamma-1 gamma-2 plus minus) (reciprocal-gammas mu))
  (define scale
    (for/fold ([scale (fl* (flexpt half mu) plus)]) ([k (in-range 1 (+ m 1))])
      (fl* scale (fl/ half (fl+ mu (->fl k))))))
  (define z (fl* sign (fl* half half)))
  (let loop ([k 1.0] [term 1.0] [sum 1.0])
    (define next (fl* term (fl/ z (fl* k (fl+ nu k)))))
    (if (fl< (flabs next) 1e-18)
        (fl* scale sum)
        (loop (fl+ k 1.0) next (fl+ sum next)))))
