#lang racket/base
;; The algebra of expressions, for values: loaded when it is first asked.
;;
;; Numbers, tuples and derivatives need no polynomials: these are half of the library,
;; and a program that never simplifies should not wait for them.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["../algebra/assumption/reference-point.rkt" at-common-reference]
 ["../algebra/elimination/characteristic.rkt" characteristic-coefficients characteristic-determinant
                                         adjugate-times]
 ["../algebra/elimination/elimination.rkt" eliminated-determinant eliminated-solutions
                                      eliminated-kernel kernel-basis kernel-basis-rank
                                      kernel-basis-vectors kernel-basis-assumptions]
 ["../algebra/rewriting/apart.rkt" partial-fractions]
 ["../algebra/rewriting/collect.rkt" collect-expression expression-coefficient]
 ["../algebra/rewriting/expand.rkt" expand-expression]
 ["../algebra/rewriting/factor.rkt" factored-expression]
 ["../algebra/rewriting/together.rkt" together-expression numerator-and-denominator]
 ["../algebra/simplify/declare-relations.rkt" declare-relations with-relations declared-relations
                                    without-relations
                                    exn:algebra:contradiction?
                                    exn:algebra:contradiction-because]
 ["../algebra/simplify/necessary-assumptions.rkt" simplify-expression/needed]
 ["../algebra/simplify/simplify-expression.rkt" simplify-expression]
 ["../algebra/zero/vanishing-factors.rkt" same-equations? symbol-alone?]
 ["../algebra/zero/common-domain.rkt" somewhere-real? part-without-value unexpected-domain]
 ["../algebra/zero/decimal-readings.rkt" too-many-to-read? reading-decimal
                                         reading-expression readings-as-written
                                         read-decimals decimals-of with-decimals-read]
 ["../algebra/zero/flonum-independence.rkt" with-unknown-flonums mentions-unknown?]
 ["../algebra/zero/existence.rkt" domain-expressions]
 ["../algebra/zero/kink.rkt" find-kinks kink-sort kink-expression kink-equations
                             kink-solved? kink-family?]
 ["../algebra/zero/kept-meaning.rkt" make-meaning meaning-with meaningful? independent-equations
                                solutions replaced]
 ["../algebra/zero/vanishing.rkt" vanishes?]
 ["../algebra/zero/zero-test.rkt"
  zero-test zero-test-status zero-test-residual zero-test-witness zero-test-value
  zero-test-bound zero-test-points zero-test-reason zero-test-decimals
  zero-test-factor zero-test-core
  zero-test-conditions zero-test-ways zero-test-left-unexpanded
  zero-test-grounds zero-test-assumptions zero-test-as-read zero-test-in-doubt])
