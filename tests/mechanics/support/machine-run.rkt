#lang racket/base
;; Machine code, run: one procedure of two flvectors, from what writes it.

(require mechanics/numeric/machine/assembler
         mechanics/numeric/machine/executable)

(provide machine-run)

;; write! : assembly -> void; rdi and rsi have the addresses of what two flvectors hold
;; -> (flvector flvector -> void); or #f where there is no memory for it
(define (machine-run write!)
  (define a (make-assembly))
  (lea! a rdi (behind rdi flvector-data))
  (lea! a rsi (behind rsi flvector-data))
  (write! a)
  (define procedures (machine-procedures (assembly->bytes a) '((0 flvector flvector))))
  (and procedures (car procedures)))
