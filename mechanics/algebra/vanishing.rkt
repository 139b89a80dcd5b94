#lang racket/base
;; Is an expression zero?  A plain yes or no, for algorithms that may not divide
;; by it.
;;
;; Residues modulo primes tell in one pass over the graph that it is not, most of
;; the time; else the canonical form decides.  Where that would grow past its
;; bounds, residues of 0 modulo several primes count as a zero: they are wrong
;; with a chance below 2⁻⁸⁰.

(require "expression.rkt" "fingerprint.rkt" "simplify.rkt" "polynomial/fraction.rkt")

(provide vanishes?)

(define (vanishes? e)
  (cond [(number? e) (zero? e)]
        [(symbol? e) #f]
        [else
         (define print (fingerprint e))
         (and (not (eq? print 'nonzero))
              (or (canonically-zero? e)
                  (eq? print 'zero)))]))

(define (canonically-zero? e)
  (define-values (F f assumptions) (normal-form e))
  (fraction-zero? f))
