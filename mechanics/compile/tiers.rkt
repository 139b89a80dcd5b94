#lang racket/base
;; Tiers: how a program is run, by its length.
;;
;; Short programs are compiled by Racket at once, which nobody notices, and are called a little
;; faster so.  Others are stretches of machine code where the processor is known.  Elsewhere long
;; ones are interpreted first, and compiled when that has paid: a run saves some nanoseconds an
;; instruction if it is compiled, and compiling takes some ten thousand times that, so the size of
;; the program does not matter; what counts is how often it was run, by anybody.  All do the same
;; operations in the same order, and give the same values.

(require "code.rkt" "interpreter.rkt" "machine-code.rkt" "program.rkt")

(provide (protect-out program->tiered-maker tiered-maker))

(define longest-compiled 50)
(define longest-at-once 500)
(define runs-that-pay 8000)

;; -> (-> (input output -> void)), as program->maker has it
(define (program->tiered-maker p)
  (define size (program-length p))
  (define machine? (> size longest-compiled))
  (cond [(and machine? (machine-procedure p)) => (lambda (run) (lambda () run))]
        [(and machine? (machine-stretches p))
         => (lambda (stretches) (program->interpreter-maker p #:stretches stretches))]
        [(<= size longest-at-once) (program->maker p)]
        [else (tiered-maker p)]))

;; counted : runs of the interpreter, by all runners; compiled : maker, or #f
;; Threads that count at once may lose a run or compile twice, no more.
(struct tiers (program interpreter [counted #:mutable] [compiled #:mutable]) #:authentic)

(define (tiered-maker p)
  (define t (tiers p (program->interpreter-maker p) 0 #f))
  (lambda () (if (tiers-compiled t) (run-compiled t) (tiers-runner t))))

(define (run-compiled t) ((tiers-compiled t)))

;; -> (input output -> void), which goes over to compiled code in time

(define (tiers-runner t)
  (define run ((tiers-interpreter t)))
  (define compiled? #f)
  (lambda (input output)
    (unless compiled?
      (set-tiers-counted! t (+ 1 (tiers-counted t)))
      (when (> (tiers-counted t) runs-that-pay)
        (unless (tiers-compiled t) (set-tiers-compiled! t (program->maker (tiers-program t))))
        (set! run (run-compiled t))
        (set! compiled? #t)))
    (run input output)))
