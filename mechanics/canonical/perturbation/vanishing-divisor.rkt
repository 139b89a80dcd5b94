#lang racket/base
;; Does the sum k·ω vanish, for these frequencies ω?
;;
;; A sum of exact numbers does if it is 0; one of decimals, up to rounding: 0.1 + 0.2 − 0.3 is
;; not 0, and a quotient by it is worth nothing.  One with symbols left does not, for there
;; are values for which it is not 0.

(provide vanishing? rounding)

(define rounding 1e-12)       ; relative to the largest of the frequencies

(define (vanishing? sum frequencies [tolerance rounding])
  (and (number? sum)
       (if (exact? sum)
           (zero? sum)
           (<= (magnitude sum)
               (* tolerance (apply max 0 (map magnitude (filter number? frequencies))))))))
