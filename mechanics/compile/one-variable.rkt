#lang racket/base
;; Generic functions of one number as flonum code.

(require racket/flonum
         "compile-function.rkt")

(provide compile-scalar)

;; f as a function from flonum to flonum, or #f; `example` is an argument to try it on.
;; Not for two threads at once: argument and value pass through vectors of its own.
(define (compile-scalar f example)
  (define code (compile-traced f example #:name 'compile-scalar))
  (and code
       (= 1 (compiled-function-outputs code))
       (flonum-function (compiled-function-runner code))))

(define (flonum-function run)
  (define input (make-flvector 1))
  (define output (make-flvector 1))
  (lambda (x)
    (flvector-set! input 0 x)
    (run input output)
    (flvector-ref output 0)))
