#lang racket/base
;; An argument that a procedure does not take, in the reader's words: Racket's own
;; `raise-argument-error` speaks of contracts, and shows a value as the implementation has it.

(require "describe.rkt"
         "../error/complain.rkt")

(provide complain-of-argument check-argument check-comes-first provide-parts)

;; expected : the value wanted, such as "a positive step"; hint : further lines, or ""
(define (complain-of-argument who expected x [hint ""])
  (complain who "expected ~a\n  given: ~a~a" expected (describe-with-value x) hint))

(define (check-argument who good? x expected)
  (unless (good? x) (complain-of-argument who expected x)))

;; first, second : names for the arguments, such as "map" and "point"
(define (check-comes-first who swapped? first second)
  (when swapped?
    (complain who "the ~a comes first, then the ~a; these look swapped" first second)))

;; (provide-parts thing? "a thing" thing-part ...): provides these procedures of a thing, which
;; readers may give anything; each complains of that in its own name.
(define-syntax-rule (provide-parts thing? what part ...)
  (begin (provide-part thing? what part) ...))

(define-syntax-rule (provide-part thing? what part)
  (begin
    (define asked
      (procedure-rename (lambda (x) (check-argument 'part thing? x what) (part x)) 'part))
    (provide (rename-out [asked part]))))
