#lang racket/base
;; Is an expression zero?  A plain yes or no, for algorithms that may not divide
;; by it.
;;
;; Residues modulo primes tell in one pass over the graph that it is not, most of
;; the time; else the canonical form decides.  Where that would grow past its
;; bounds, residues of 0 modulo several primes count as a zero: they are wrong
;; with a chance below 2⁻⁸⁰.  Their roots are those of positive numbers, so they do
;; not count where assumptions have been made.

(require "fingerprint.rkt"
         "../assumption/assumption-set.rkt"
         "../polynomial/fraction.rkt"
         "../simplify/simplify-expression.rkt")

(provide vanishes?)

(define (vanishes? e [A no-assumptions])
  (cond [(number? e) (zero? e)]
        [(symbol? e) #f]
        [else
         (define print (fingerprint e))
         (and (not (eq? print 'nonzero))
              (or (canonically-zero? e A)
                  (and (eq? print 'zero) (null? (assumptions-relations A)))))]))

(define (canonically-zero? e A)
  (define-values (F f grounds) (normal-form e A))
  (fraction-zero? f))
