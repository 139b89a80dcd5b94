#lang racket/base
;; Judgments at many points on both sides of every condition, and at the witness of a refutation.

(require "fault.rkt" "flonum.rkt" "point.rkt" "relation.rkt" "witness.rkt"
         "../statement.rkt")

(provide small-numbers judged-at-points judged-at-witness)

(define tries 120)

;; On both sides of every condition: small numbers, often 0 and equal ones.
(define (small-numbers symbols)
  (define few (pick '((0 1 2 -1) (1 2 1/2 -1 -2 -1/2 3 1/3 -5/2 3/2 -3))))
  (for/hasheq ([s (in-list symbols)]) (values s (pick few))))

;; judge : numbers -> #t where all is right, a fault, or #f where it cannot tell
;; enough : points at which all is right
(define (judged-at-points symbols assumed draw enough judge)
  (let loop ([k 0] [right 0])
    (define numbers (draw symbols))
    (define held? (all-hold? assumed (make-point numbers 0) flonum-intervals))
    (define v (and held? (judge numbers)))
    (cond [(fault? v) v]
          [(= right enough) #f]
          [(= k tries) (if (zero? right) 'unjudged #f)]
          [else (loop (+ k 1) (if v (+ right 1) right))])))

;; A refutation is right if it is so for one choice of numbers its witness does not name.
(define (judged-at-witness symbols witness draw judge)
  (define named (witness-numbers (or witness '())))
  (define verdicts
    (for/list ([_ (in-range 6)])
      (judge (for/fold ([all (draw symbols)]) ([(s x) (in-hash named)]) (hash-set all s x)))))
  (cond [(memq #t verdicts) #f]
        [(memq #f verdicts) 'unjudged]
        [else (car verdicts)]))
