#lang racket/base
;; Exports of a library with contracts were undefined once the library was required at the
;; prompt: (new c%) told of "lifted/1.1", and advised to write it (/ lifted 1.1).

(require "../support/checks.rkt" "../support/run-text.rkt")

(define (typed . lines) (apply session '("-I" "mechanics") lines))

(test-case "objects are made at the prompt"
  (define-values (output errors)
    (typed "(require racket/class)"
           "(define c% (class object% (super-new) (define/public (m) 42)))"
           "(send (new c%) m)"))
  (check-equal? output '("42"))
  (check-false (regexp-match? #rx"undefined|lifted" errors)))

(test-case "a procedure defined before the library finds what has a contract in it"
  (define-values (output errors)
    (typed "(define (made c%) (is-a? (make-object c%) c%))"
           "(require racket/class)"
           "(made object%)"))
  (check-equal? output '("#t"))
  (check-false (regexp-match? #rx"lifted" errors)))
