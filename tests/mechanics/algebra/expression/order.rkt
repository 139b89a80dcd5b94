#lang racket/base
;; The order on expressions is total, and equal expressions are not apart.

(require racket/list
         mechanics/algebra/expression/order
         mechanics/algebra/expression/read
         "../../support/checks.rkt")

(define in-order
  (map datum->expression
       '(-1 1/2 2 a m x (+ a b) (+ a b c) (f t) (x t) (cos x) (sin x) ((D f) t)
            (((expt D 2) f) t))))

(test-case "numbers, symbols, sums, functions, derivatives"
  (for ([tail (in-list (let loop ([es in-order]) (if (null? es) '() (cons es (loop (cdr es))))))]
        #:when #t [b (in-list (cdr tail))])
    (check-true (< (expression-compare (car tail) b) 0) (format "~a before ~a" (car tail) b))
    (check-true (> (expression-compare b (car tail)) 0) (format "~a after ~a" b (car tail)))))

(test-case "sorting does not depend on the order given"
  (parameterize ([current-pseudo-random-generator (make-pseudo-random-generator)])
    (random-seed 7)
    (for ([_ (in-range 20)])
      (check-equal? (sort (shuffle in-order) expression<?) in-order))))

(test-case "operands of sums and products may be written in any order"
  (check-equal? (expression-compare (datum->expression '(+ a (* b c)))
                                    (datum->expression '(+ (* c b) a)))
                0)
  (check-not-equal? (expression-compare (datum->expression '(- a b))
                                        (datum->expression '(- b a)))
                    0))

(test-case "derivatives count"
  (define es (map datum->expression '(x (x t) ((D x) t) (((expt D 2) x) t))))
  (check-equal? (map derivative-order es)
                '(0 0 1 2)))

(test-case "numbers by value, exact ones first, then by imaginary parts"
  (define numbers (list -inf.0 -1 0 -0.0 0.0 1/2 0.5 1-2i 1 1+2i 1.0 1.0+2.0i +inf.0 +nan.0))
  (for* ([(a i) (in-parallel numbers (in-naturals))] [(b j) (in-parallel numbers (in-naturals))])
    (define sign (cond [(= i j) 0] [(< i j) -1] [else 1]))
    (check-equal? (expression-compare a b) sign (format "~a ~a" a b))))
