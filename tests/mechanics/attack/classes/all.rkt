#lang racket/base
;; The classes by name.

(require "decimals.rkt" "declared-relations.rkt" "degenerate-factors.rkt" "disguised.rkt"
         "domains.rkt" "kinks.rkt" "literal-functions.rkt" "logarithms.rkt" "motions.rkt"
         "rational-function-angles.rkt" "real-identities.rkt" "roots-and-signs.rkt"
         "surface-kinks.rkt"
         "symbolic-integrals.rkt")

(provide class-names single-classes claims-of-a-subject random-subject)

;; ((name . -> subject) ...)
(define classes
  (list (cons 'roots-and-signs roots-and-signs)
        (cons 'declared-relations declared-relations)
        (cons 'rational-function-angles rational-function-angles)
        (cons 'logarithms logarithms)
        (cons 'literal-functions literal-functions)
        (cons 'kinks kinks)
        (cons 'motions motions)
        (cons 'decimals decimals)
        (cons 'symbolic-integrals symbolic-integrals)
        (cons 'degenerate-factors degenerate-factors)
        (cons 'surface-kinks surface-kinks)
        (cons 'domains domains)
        (cons 'real-identities real-identities)
        (cons 'disguised disguised-identity)
        (cons 'false-by-little false-by-little)))

(define class-names (map car classes))

;; Of their subjects one thing is asked, of others three.
(define single-classes
  '(motions symbolic-integrals degenerate-factors surface-kinks domains
    disguised false-by-little))
(define (claims-of-a-subject name) (if (memq name single-classes) 1 3))

;; The k-th subject of a class, with a seed: always the same.
(define (random-subject name seed k)
  (parameterize ([current-pseudo-random-generator (make-pseudo-random-generator)])
    (random-seed (modulo (+ (* 48271 (+ k 1)) (* 69621 seed)
                            (equal-hash-code (symbol->string name)))
                         2147483647))
    ((cdr (assq name classes)))))
