#lang racket/base
;; Texts of data within bounds: all of it is written, or counted.

(require mechanics/algebra/expression/write
         "../../support/checks.rkt")

(define (text d limit) (parameterize ([print-limit limit]) (datum->text d)))

(test-case "what is not written is counted, atom by atom"
  (define d '(a (b c) (d (e f) g)))
  (check-equal? (text d #f) "(a (b c) (d (e f) g))")
  (check-equal? (text d 7) (text d #f))
  (check-equal? (text d 3) "(a (b c) ...4 more)")
  (check-equal? (text d 1) "(a ...6 more)"))

(test-case "shared pairs are counted where they stand, in the time of one"
  (define (doubled n) (if (= n 0) 'a (let ([half (doubled (- n 1))]) (list half half))))
  (check-equal? (text (cons 'f (doubled 10)) 1) "(f ...1024 more)")
  (check-equal? (text (cons 'f (doubled 400)) 1) "(f ...10^120 more)"))
