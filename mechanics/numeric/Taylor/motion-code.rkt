#lang racket/base
;; Machine code for motions and their steps: their coefficients, and the sums of these.

(require "convolution-code.rkt" "polynomial-code.rkt" "recurrence-list.rkt" "recurrence-code.rkt"
         "../machine/assembler.rkt" "../machine/executable.rkt")

(provide (protect-out motion-code follow-code))

;; count : of all rows; states, slopes : lists of rows; starts, endless : recurrences; ending : list
;; of (last order . recurrence); ends : the greatest order of a row that ends
;; -> list of procedures; or #f where there is no memory for them
;;     h flvectors tape sizes     the expansion in the unit h (recurrence-code.rkt)
;;     u tape y lost z rest       the state at the time u (polynomial-code.rkt)
;;     u tape out                 the same, rounded
;;     u tape out                 its rates
(define (motion-code count states slopes starts ending endless order ends)
  (define lasts (for/list ([y (in-list states)]) (max 1 (min order (last-index y)))))
  (define c (tape (make-assembly) (+ order 1) count))
  (define (entry write! . types)
    (define l (make-label))
    (label-here! (tape-a c) l)
    (write!)
    (list* (label-place l) 'flonum types))
  (define entries
    (list (entry (lambda ()
                   (write-expansion! c states slopes starts ending endless ends #f
                                     (lambda () (write-sizes! c states r15))))
                 'vector 'flvector 'flvector)
          (entry (lambda () (write-advance! c (map cons states lasts)))
                 'flvector 'flvector 'flvector 'flvector 'flvector)
          (entry (lambda () (write-sums! c (map cons states lasts))) 'flvector 'flvector)
          (entry (lambda () (write-sums! c (map cons slopes (map sub1 lasts))))
                 'flvector 'flvector)))
  (machine-procedures (assembly->bytes (tape-a c)) entries))

;; The same of rows that are known: (h flvectors tape sizes -> void) alone, where h and sizes do not
;; matter
(define (follow-code count inputs outputs starts ending endless order ends)
  (define c (tape (make-assembly) (+ order 1) count))
  (write-expansion! c inputs outputs starts ending endless ends #t void)
  (machine-procedures (assembly->bytes (tape-a c)) '((0 flonum vector flvector flvector))))
