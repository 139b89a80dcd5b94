#lang racket/base
;; What a loop over flonums returns.
;;
;; The compiler keeps the sums of a loop in registers if operations alone use them.  A sum that is
;; returned as it is, or handed to a procedure, is made an object in memory at every turn instead;
;; as the value of an operation it is made one once.

(require racket/unsafe/ops)

(provide unboxed)

(define-syntax-rule (unboxed x) (unsafe-fl* 1.0 x))
