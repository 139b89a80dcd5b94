#lang racket/base
;; Symbols in place of the scalars of a value: what stands for any value of its shape.
;; Nobody could have written them, so they meet no other of their name.

(require "shape.rkt")

(provide symbols-like typical-object)

(define (symbols-like x name)
  (scalars->structure x (lambda (k) (string->uninterned-symbol (format "~a~a" name k)))))

;; As scmutils has it
(define (typical-object s) (symbols-like s "x"))
