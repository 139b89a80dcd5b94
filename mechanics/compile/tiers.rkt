#lang racket/base
;; Three ways to run a program, and the choice between them.
;;
;; Short programs are compiled by Racket at once, which nobody notices, and are called a little
;; faster so.  Others become machine code where the processor is known and has all their operations.
;; Elsewhere they are closures first, and compiled when that has paid: a run saves some nanoseconds
;; an instruction if it is compiled, and compiling takes some ten thousand times that, so the size
;; of the program does not matter; only its runs count, by anybody.  All do the same
;; operations in the same order, and give the same values.

(require "Racket-code.rkt" "closures.rkt" "program.rkt"
         "../numeric/machine/assembler.rkt" "../numeric/machine/executable.rkt"
         "../numeric/machine/straight-code.rkt")

(provide (protect-out program->tiered-maker tiered-maker machine-procedure))

(define longest-compiled 50)
(define runs-that-pay 8000)

;; -> (-> (input output -> void)), as program->maker has it
(define (program->tiered-maker p)
  (cond [(<= (program-length p) longest-compiled) (program->maker p)]
        [(machine-procedure p) => (lambda (run) (lambda () run))]
        [else (tiered-maker p)]))

;; -> (input output -> void), flvectors that do not overlap; or #f where there is no machine code
(define (machine-procedure p)
  (define instructions (program-instructions p))
  (define (code)
    (define a (make-assembly))
    (lea! a rdi (behind rdi flvector-data))
    (lea! a rsi (behind rsi flvector-data))
    (write-procedure! a (program-inputs p) 0 instructions (program-outputs p))
    (assembly->bytes a))
  (define procedures
    (and (straight-code? instructions (program-inputs p))
         (machine-procedures (code) '((0 flvector flvector)))))
  (and procedures (car procedures)))

;; closures : maker; counted : runs of them, by all runners; compiled : maker, or #f
;; Threads that count at once may lose a run or compile twice, no more.
(struct tiers (program closures [counted #:mutable] [compiled #:mutable]) #:authentic)

(define (tiered-maker p)
  (define t (tiers p (program->closure-maker p) 0 #f))
  (lambda () (if (tiers-compiled t) ((tiers-compiled t)) (tiers-runner t))))

;; -> (input output -> void), which goes over to compiled code in time
(define (tiers-runner t)
  (define run ((tiers-closures t)))
  (define compiled? #f)
  (lambda (input output)
    (unless compiled?
      (set-tiers-counted! t (+ 1 (tiers-counted t)))
      (when (> (tiers-counted t) runs-that-pay)
        (unless (tiers-compiled t) (set-tiers-compiled! t (program->maker (tiers-program t))))
        (set! run ((tiers-compiled t)))
        (set! compiled? #t)))
    (run input output)))
