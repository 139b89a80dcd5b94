#lang racket/base
;; Formulas as on paper and in other programs, in prefix form, for a reader to type.
;;
;; Forms that Racket read are put together to the text they were read from, which is read as a
;; formula (algebra/notation/read-paper.rkt).  The form to be offered is read back by Racket,
;; and both have the same values at some points: else nothing is offered.

(require "operation-sign.rkt" "other-notation.rkt" "same-values.rkt" "typed-text.rkt"
         "../written-form.rkt"
         "../../algebra/notation/read-paper.rkt")

(provide prefix-form text->prefix-form typed-formula about-escapes advice-to-write)

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

;; form : that was read in place of the text typed -> advice, or #f for the value of a call
(define (advice-to-write form)
  (define sentence
    (cond [(not (pair? form)) "it is written ~a"]
          [(not (symbol? (car form))) #f]
          [(memq (car form) '(+ - * / expt < > = <= >=)) "operations come first: ~a"]
          [else "a call stands in parentheses: ~a"]))
  (and sentence (format sentence (form->text form))))

;; k*|x|, which Racket reads as the name k*x; |x - y|, and TeX's \frac12 -> advice, or #f
(define (about-escapes stx)
  (define name (syntax-e stx))
  (cond [(not (and (symbol? name) (escaped? stx))) #f]
        [(prefix-form (list stx))
         => (lambda (form) (and (not (eq? form name)) (advice-to-write form)))]
        [(regexp-match? #px"\\s" (symbol->string name))
         "bars stand around a name with spaces in it; an absolute value is (abs x)"]
        [(formula-like? name) about-formulas]
        [else #f]))
