#lang racket/base
;; Arbitrary precision for tests that can have it: math/bigfloat wants a shared
;; library, libmpfr, which is not on every machine.

(provide bigfloats? no-bigfloats big)

(define library 'math/bigfloat)

;; The export of that name, kept: what a typed module exports is expanded at each dynamic-require.
(define big
  (let ([known (make-hasheq)])
    (lambda (name) (hash-ref! known name (lambda () (dynamic-require library name))))))

;; Without the shared library bigfloats load but cannot be made.
(define bigfloats?
  (with-handlers ([exn:fail? (lambda (e) #f)])
    ((big 'bigfloat?) ((big 'bf+) ((big 'bf) 1) ((big 'bf) 2)))))

(define no-bigfloats
  "MPFR (Debian: apt install libmpfr6) is not installed: no bigfloats to compute with")
