#lang racket/base
;; Two tiers: long programs are interpreted first, and compiled when that has paid.
;;
;; A run saves some nanoseconds an instruction if it is compiled, and compiling takes some ten
;; thousand times that, so the size of the program does not matter: what counts is how often
;; it was run, by anybody.  Short programs are compiled at once, which nobody notices.  Both
;; tiers do the same operations in the same order, and give the same values.

(require "code.rkt" "interpreter.rkt" "program.rkt")

(provide program->tiered-maker)

(define longest-at-once 500)
(define runs-that-pay 8000)

;; -> (-> (input output -> void)), as program->maker has it
(define (program->tiered-maker p)
  (if (<= (program-length p) longest-at-once) (program->maker p) (tiered-maker p)))

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
