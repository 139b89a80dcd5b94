#lang racket/base
;; Colours of numbers.

(require mechanics/show/plot/color-map
         "../../support/checks.rkt")

;; Relative luminance, of linear red, green and blue (ITU-R BT.709)
(define (luminance c)
  (define (linear byte)
    (define x (/ byte 255.0))
    (if (<= x 0.04045) (/ x 12.92) (expt (/ (+ x 0.055) 1.055) 2.4)))
  (apply + (map * '(0.2126 0.7152 0.0722) (map linear c))))

(test-case "in each colour map more is lighter, from end to end"
  (for ([name color-map-names])
    (define all (for/list ([k 101]) (luminance (color-between name (/ k 100.0)))))
    (check-true (apply <= all) (format "~a" name))
    (check-true (< (* 5 (+ 0.05 (car all))) (+ 0.05 (car (reverse all)))) (format "~a" name))))

(test-case "ends, what is beyond them, and no number"
  (check-equal? (color-between 'grey 0) '(0 0 0))
  (check-equal? (color-between 'grey 0.5) '(128 128 128))
  (check-equal? (color-between 'viridis 7) '(253 231 37))
  (check-equal? (color-between 'plasma +nan.0) '(190 190 190)))
