#lang racket/base
;; The comma after an equation of a witness was not counted: where the equation just fitted,
;; the line was one column too long.

(require racket/string mechanics
         mechanics/show/display/result-lines
         "../support/checks.rkt")

(define verdict
  (prove-zero (for/sum ([s '(a b_1 c_22 d e_1 f_22 g h_1 i_22 j k_1 l_22)]) s)))

(test-case "no line is longer than it may be, whatever the width"
  (check-eq? (verdict-status verdict) 'refuted)
  (for ([width (in-range 20 100)])
    (for ([line (string-split (value->lines verdict width) "\n")]
          #:when (regexp-match? #rx"^ +(at:|[a-l])" line))
      (check-true (<= (string-length line) width) (format "~a: ~a" width line)))))
