#lang racket/base
;; The ticks of an axis and the numbers beside them.

(require "../../../../mechanics/show/plot/axes/plot-ticks.rkt"
         "../../support/checks.rkt")

(define (labels from to) (filter values (map tick-label (ticks-between from to))))

;; Ends of the axis, the numbers, and how many ticks there are with those that have none
(define table
  '((0 1 ("0" ".2" ".4" ".6" ".8" "1") 11)
    (0 6.3 ("0" "2" "4" "6") 7)
    (-3.2 3.2 ("-2" "0" "2") 7)
    (-10 10 ("-10" "-5" "0" "5" "10") 21)
    (2.5 17 ("2.5" "5" "7.5" "10" "12.5" "15") 6)
    (0 50 ("0" "10" "20" "30" "40" "50") 11)
    (-1 0 ("-1" "-.8" "-.6" "-.4" "-.2" "0") 11)
    (1000 1001 ("1000" "1000.2" "1000.4" "1000.6" "1000.8" "1001") 11)
    (0 100000 ("0" "20000" "40000" "60000" "80000" "1×10⁵") 11)
    (0 0.0004 ("0" ".0001" ".0002" ".0003" ".0004") 9)
    (-2e-7 2e-7 ("-1×10⁻⁷" "0" "1×10⁻⁷") 7)))

(test-case "numbers are few, round and short"
  (for ([row (in-list table)])
    (define-values (from to numbers count) (apply values row))
    (check-equal? (labels from to) numbers)
    (check-equal? (length (ticks-between from to)) count (format "~a" numbers))))

;; Ends, decimal logarithms, with the numbers beside a logarithmic axis
(test-case "numbers of a logarithmic axis are powers of ten, some of them, or round"
  (for ([row '((0 2 ("1" "10" "100")) (-3 3.5 ("10⁻³" ".01" ".1" "1" "10" "100" "1000"))
               (-18 0 ("10⁻¹⁶" "10⁻¹²" "10⁻⁸" "10⁻⁴" "1")) (0.3 1.7 ("10" "20" "30" "40" "50")))])
    (define-values (low high numbers) (apply values row))
    (define ticks (log-ticks-between low high))
    (check-equal? (filter values (map tick-label ticks)) numbers)
    (check-true (andmap (lambda (t) (<= low (tick-value t) high)) ticks)))
  (check-equal? (map tick-label (log-ticks-between -0.9999999999999999 -1e-16))
                '(".1" #f #f #f #f #f #f #f #f "1"))
  (check-equal? (length (log-ticks-between 0 2)) 19))

(test-case "ticks ascend at equal distances, within the ends, whatever these are"
  (for ([_ (in-range 300)])
    (define size (expt 10.0 (- (random 20) 10)))
    (define from (* size 10 (- (random) 0.5)))
    (define to (+ from (* size (+ 0.01 (random)))))
    (define values (map tick-value (ticks-between from to)))
    (define steps (for/list ([a (in-list values)] [b (in-list (cdr values))]) (- b a)))
    (check-true (<= from (apply min values) (apply max values) to))
    (check-true (and (> (car steps) 0) (apply = steps)) (format "~a to ~a" from to))
    (check-true (<= 2 (length (labels from to)) 8) (format "~a to ~a" from to))))
