#lang racket/base
;; D obeys the laws of derivations, at points of every kind of scalar.

(require mechanics/calculus/derivative
         mechanics/calculus/literal-function
         mechanics/value/signature
         "../support/random.rkt" "../support/same.rkt"
         "../support/laws/derivation.rkt" "../support/laws/law.rkt"
         "../support/random/element.rkt")

(define generic-derivation
  (derivation D (lambda (i f) ((partial i) f))))

(define (check-derivation title number seed)
  (check-laws (string-append "D at " title) derivation-laws generic-derivation
              (draw-functions number random-function) same? #:seed seed)
  (check-laws (string-append "partial at " title) partial-laws generic-derivation
              (draw-functions number random-function-of-two) same? #:seed (add1 seed)))

(check-derivation "flonums" random-flonum 411)
(check-derivation "exact rationals" random-rational 413)
(check-derivation "symbols" (lambda () (random-choice 'a 'b 'c)) 415)
(check-derivation "expressions" random-expression 417)
(check-derivation "dual numbers" random-dual 419)
(check-derivation "complex numbers" (lambda () (/ (random-complex) 4)) 421)

(define (random-literal)
  (literal-function (random-choice 'f 'g 'h)))
(check-laws "D of unknown functions at symbols" derivation-laws generic-derivation
            (draw-functions (lambda () (random-choice 'a 'b)) random-literal) same? #:seed 423)
(check-laws "partial of unknown functions at symbols" partial-laws generic-derivation
            (draw-functions (lambda () (random-choice 'a 'b))
                            (lambda ()
                              (literal-function (random-choice 'F 'G) (-> (X Real Real) Real))))
            same? #:seed 424)
