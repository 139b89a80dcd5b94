#lang racket/base
;; A value as a result is shown: simplified, unless another form was asked for, in
;; the book's notation.
;;
;; What is ours becomes text that prints as itself; what is not (strings, lists,
;; pictures) stays as it is for Racket to print, its elements simplified.

(require "text.rkt"
         "../calculus/verdict.rkt"
         "../algebra/expression.rkt"
         "../generic/describe.rkt" "../generic/kind.rkt"
         "../value/simplify.rkt")

(provide simplified-result plain-result)

;; What to print in place of x; ours takes lines of at most `width` columns.
;; The elements of a list or vector are simplified though Racket prints it.
(define (simplified-result x width)
  (cond [(in-notation? x)
         (define-values (shown assumptions) (as-shown x))
         (laid-out (value->lines shown width assumptions))]
        [else (simplified-elements x width)]))

(define (simplified-elements x width)
  (define (simplified-element e)
    (cond [(unprintable? e) (laid-out (value->lines e width))]
          [(in-notation? e)
           (define-values (shown assumptions) (as-shown e))
           shown]
          [else (simplified-elements e width)]))
  (cond [(list? x) (map simplified-element x)]
        [(vector? x) (list->vector (map simplified-element (vector->list x)))]
        [else x]))

;; The same without simplification.
(define (plain-result x width)
  (if (in-notation? x) (laid-out (value->lines x width)) x))

;; Text that prints as itself in all of Racket's modes.
(struct laid-out (text)
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write
  (lambda (l port mode) (write-string (laid-out-text l) port)))

;; Is x written by us?  Numbers are not: they look the same either way.
(define (in-notation? x)
  (or (symbolic? x)
      (has-kind? x)
      (verdict? x)
      (unprintable? x)))

;; A procedure that Racket would print as #<procedure:its-name>.
(define (unprintable? x)
  (and (procedure? x) (not (custom-write? x))))
