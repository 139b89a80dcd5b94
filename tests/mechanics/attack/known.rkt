#lang racket/base
;; Faults the library is known to have, so that the tests are green until they are mended.
;;
;; A fault that is not listed fails the test of the attack; one that is listed is counted
;; and printed.  Who mends a fault takes its line away.

(provide known-fault?)

;; (class kind why)
(define known-faults
  '((roots-and-signs values-differ "signs are asked of normalised polynomials (A1)")
    (roots-and-signs opposites-proved "both under assumptions of their own (A1)")
    (roots-and-signs assumptions-hold-nowhere "signs of normalised factors are assumed (A2)")
    (roots-and-signs nowhere-defined "a form that is zero is proof enough (A6)")
    (roots-and-signs no-value-at-witness "witnesses may be complex (A4)")
    (roots-and-signs result-nowhere-defined "signs of normalised factors (A1)")
    (declared-relations values-differ "signs are asked of normalised polynomials (A1)")
    (declared-relations assumptions-hold-nowhere "assumed against what is declared (A3)")
    (declared-relations nowhere-defined "a form that is zero is proof enough (A6)")
    (declared-relations no-value-at-witness "witnesses may be complex (A4)")
    (rational-function-angles raised "angles with sums in their denominators (C3)")
    (rational-function-angles values-differ "angles with sums in their denominators (C3)")
    (rational-function-angles no-difference-at-witness "rounding of exact arguments (B1)")
    (rational-function-angles no-value-at-witness "witnesses may be complex (A4)")
    (logarithms values-differ "signs are asked of normalised polynomials (A1)")
    (logarithms assumptions-hold-nowhere "signs of factors are assumed one by one (A3)")
    (logarithms nowhere-defined "a form that is zero is proof enough (A6)")
    (logarithms no-value-at-witness "witnesses may be complex (A4)")
    (logarithms result-nowhere-defined "signs of normalised factors (A1)")
    (literal-functions function-of-two-values "values of equal arguments differ (B3)")
    (literal-functions no-value-at-witness "witnesses may be complex (A4)")
    (kinks values-differ "roots of squares of differences (A1)")
    (kinks assumptions-hold-nowhere "signs of normalised factors are assumed (A2)")
    (kinks nowhere-defined "a form that is zero is proof enough (A6)")
    (kinks no-value-at-witness "witnesses may be complex (A4)")
    (kinks no-difference-at-witness "rounding decides a sign (B2)")
    (motions not-smooth "jumps and kinks have the derivative 0 (A5)")
    (motions residual "jumps and kinks have the derivative 0 (A5)")
    (disguised assumptions-hold-nowhere "signs of normalised factors are assumed (A2)")
    (declared-relations no-difference-at-witness "witnesses may be complex (A4)")
    (decimals no-value-at-witness "witnesses may be complex (A4)")))

(define (known-fault? class kind)
  (for/or ([entry (in-list known-faults)])
    (and (eq? class (car entry)) (eq? kind (cadr entry)))))
