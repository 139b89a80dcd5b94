#lang racket/base
;; Values that are answers and yet neither true nor false: a verdict may be undecided, and
;; Racket takes for true whatever is not #f, a refutation too.
;;
;; A struct with the property names in a sentence the question to ask instead.

(require "../error/complain.rkt" "../error/message-words.rkt")

(provide prop:no-truth-value truth)

;; The value of the property is that sentence.
(define-values (prop:no-truth-value no-truth-value? what-to-ask)
  (make-struct-type-property 'no-truth-value))

;; x, of which `who` asks whether it is true; an error if it has no truth value.
(define-syntax-rule (truth who x)
  (let ([v x])
    (if (boolean? v) v (checked 'who v))))

(define (checked who v)
  (when (no-truth-value? v)
    (complain who "~a\n  given: ~a" (what-to-ask v) (first-line (format "~a" v))))
  v)
