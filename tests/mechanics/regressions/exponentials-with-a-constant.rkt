#lang racket/base
;; 1/(1 + e e^(-a/3)) had two forms: which exponentials are basic depended on whether
;; e^(1 - a/3) was written as one or as a product, and with it what numerator and
;; denominator, reduced, have in common.

(require mechanics/algebra/expression/expression
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/expression/read
         "../support/checks.rkt")

(define (simplified datum)
  (expression->datum (simplify-expression (datum->expression datum))))

(define (check-one-form form . spellings)
  (for ([d (in-list (cons form spellings))])
    (check-equal? (simplified d) form (format "~s" d))))

(test-case "a quotient has one form, however its exponentials are written"
  (check-one-form '(/ (exp (* 1/3 a)) (+ (exp (* 1/3 a)) (exp 1)))
                  '(/ 1 (+ 1 (exp (- 1 (/ a 3)))))
                  '(/ 1 (+ 1 (* (exp 1) (exp (/ a -3)))))
                  '(/ 1 (+ 1 (/ (exp 1) (expt (exp a) 1/3))))
                  '(/ (exp (- (/ a 3) 1)) (+ (exp (- (/ a 3) 1)) 1)))
  (check-one-form '(/ (exp (* 1/3 a)) (+ e (exp (* 1/3 a))))
                  '(/ 1 (+ 1 (* e (exp (/ a -3))))))
  (check-one-form '(/ 1 (+ (exp (* 1/2 b)) (exp a)))
                  '(/ (exp (- (* -1/2 b) a)) (+ (exp (- 0 a)) (exp (* -1/2 b))))
                  '(/ 1 (* (exp a) (+ 1 (exp (- (* 1/2 b) a)))))))

(test-case "a sum over a quotient is split or not, however its exponentials are written"
  (define whole '(+ (/ 1 (+ b (exp (- (+ (/ 1 3) b (/ a 3)))))) (exp (+ a b))))
  (define apart
    '(+ (/ 1 (+ b (/ 1 (* (exp 1/3) (exp b) (exp (/ a 3)))))) (* (exp a) (exp b))))
  (check-equal? (simplified whole) (simplified apart))
  (check-equal? (simplified (simplified whole)) (simplified whole)))

(test-case "exponents of several atoms stay together where nothing divides them"
  (check-equal? (simplified '(+ (exp (- a b)) (* (exp a) (exp b)) (exp (- 1 a))))
                '(+ (exp (- a b)) (exp (- 1 a)) (exp (+ a b)))))
