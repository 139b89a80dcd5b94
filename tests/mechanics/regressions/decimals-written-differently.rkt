#lang racket/base
;; Two decimals a unit of the last place apart were both read as the same exact number: that
;; they are equal was proved, and that one is the other's opposite as well.

(require mechanics "../support/checks.rkt")

(define difference (- (* 2.0000000000000004 'x) (* 2.0 'x)))

(test-case "decimals written differently are not proved to be equal"
  (check-true (undecided? (prove-zero difference)))
  (check-true (undecided? (prove-zero (* 2 difference))))
  (check-equal? (verdict-reason (prove-zero difference)) 'decimals)
  (check-true (undecided? (prove-zero (- (* 0.1 'x 3) (* 0.3 'x))))))

(test-case "a decimal beside the exact number it was computed from still is"
  (define ((L-harmonic m k) (up t q v)) (- (* 1/2 m (square v)) (* 1/2 k (square q))))
  (check-true (proved? (prove-zero (- (* 1/10 'x) (* 0.1 'x)))))
  (check-true (proved? (verify-solution (L-harmonic 1 2) (lambda (t) (cos (* (sqrt 2.0) t)))))))

;; Multiples of 1/128, so that nothing is rounded.
(define (sum-of n)
  (for/fold ([sum 0]) ([k (in-range 1 (+ n 1))])
    (+ sum (- (cos (* (/ k 128.0) 'x)) (cos (* (/ k 128) 'x))))))

(test-case "many decimals are not read, and the verdict says so"
  (check-true (proved? (prove-zero (sum-of 3))))
  (check-regexp-match
   #rx"decimals: .* and 26 more stand in the way, too many to be read as exact numbers"
   (format "~a" (prove-zero (sum-of 30)))))

(test-case "as many decimals as are told have no others beside them"
  (define v (verify-equal (* 0.30000000000000004 (+ 'a (* 1.7 (sin 'a))))
                          (+ (* 0.3 'a) (* 0.51 (sin 'a)))))
  (check-regexp-match #rx"decimals: 0.30000000000000004, 1.7, 0.3, 0.51 stand in the way; exact"
                      (format "~a" v)))
