#lang racket/base
;; Formulas as on paper and in other programs, in prefix form: what a reader is told to type.
;;
;; Forms that Racket read are put together to the text they were read from, which is read as a
;; formula (algebra/notation/read-paper.rkt).  What it is to be offered as is read back by Racket,
;; and both have the same values at some points: else nothing is offered.

(require "operation-sign.rkt" "other-notation.rkt" "same-values.rkt" "typed-text.rkt"
         "../written-form.rkt"
         "../../algebra/notation/read-paper.rkt")

(provide prefix-form text->prefix-form typed-formula about-escapes)

;; forms : in a row, syntaxes or data; known? : symbol -> is it a name of something?
;; -> the form to write instead, a datum, or #f
(define (prefix-form forms [known? nothing-known])
  (define-values (text operands) (typed-text forms known?))
  (and text (text->prefix-form text operands known?)))

(define (nothing-known name) #f)

;; text, operands : of typed-text
(define (text->prefix-form text operands known?)
  (define reading (read-paper text known? foreign-name?))
  (define (whole d) (with-operands d operands))
  (and reading
       (let ([form (as-typed reading)])
         (and (same-values? reading form) (whole form)))))

(define (with-operands d operands)
  (cond [(pair? d) (map (lambda (part) (with-operands part operands)) d)]
        [(assq d operands) => cdr]
        [else d]))

;; name : symbol -> form such as (expt x 2), or #f if it is no formula
(define (typed-formula name [known? nothing-known])
  (define text (symbol->string name))
  (define form (and (not (regexp-match? #px"\\s" text)) (text->prefix-form text '() known?)))
  (and (pair? form) form))

;; k*|x|, which Racket reads as the name k*x; and |x - y| -> advice, or #f
(define (about-escapes stx)
  (define name (syntax-e stx))
  (cond [(not (and (symbol? name) (escaped? stx))) #f]
        [(regexp-match? #px"\\s" (symbol->string name))
         "bars stand around a name with spaces in it; an absolute value is (abs x)"]
        [(formula-like? name) about-formulas]
        [else #f]))
