#lang racket/base
;; That erf(−x) is −erf(x) was not proved, though the table of operations says that it is odd; nor
;; was it of any odd function that is neither circular nor hyperbolic.

(require rackunit
         (prefix-in m: mechanics))

(define functions (list m:erf m:asin m:atan m:asinh m:atanh m:sgn))

(test-case "an odd function of an opposite is the opposite, by proof"
  (for ([f functions])
    (check-true (m:proved? (m:verify-equal (f (m:- 'x)) (m:- (f 'x)))))
    (check-true (m:proved? (m:verify-equal (f (m:- 'a 'b)) (m:- (f (m:- 'b 'a))))))))

(test-case "it is written with the argument that begins with no minus sign"
  (check-equal? (m:expression (m:simplify (m:erf (m:* -2 'x)))) '(* -1 (erf (* 2 x)))))

(test-case "of others nothing is claimed: acos x + acos -x is π, and an angle has two sides"
  (check-false (m:proved? (m:verify-equal (m:acos (m:- 'x)) (m:- (m:acos 'x)))))
  (check-false (m:proved? (m:verify-equal (m:atan (m:- 'y) 'x) (m:- (m:atan 'y 'x))))))
