#lang racket/base
;; Tests that cannot run here say why; the runner lists the reasons and counts
;; them.  A file run alone prints them.

(provide
 skip          ; (skip reason) : leave something untested, visibly
 skip-unless   ; (skip-unless condition reason body ...) : a syntax
 skipped)      ; (skipped) -> the reasons so far, first one first

(define reasons '())

(define (skip reason)
  (set! reasons (cons reason reasons))
  (printf "skipped: ~a\n" reason))

(define (skipped) (reverse reasons))

(define-syntax-rule (skip-unless condition reason body ...)
  (if condition
      (let () body ... (void))
      (skip reason)))
