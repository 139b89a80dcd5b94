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
        [(and (list? x) (ormap verdict? x) (textual? x)) (laid-out (stacked x width))]
        [else (simplified-elements x width)]))

;; A list in which there are verdicts, which take several lines: each element begins one.
(define (stacked xs width)
  (define indentation "      ")
  (define (text x)
    (define result (simplified-result x (- width (string-length indentation))))
    (regexp-replace* #rx"\n" (format "~v" result) (string-append "\n" indentation)))
  (string-append
   "(list " (text (car xs))
   (apply string-append
          (for/list ([x (in-list (cdr xs))]) (string-append "\n" indentation (text x))))
   ")"))

;; Nothing that an editor would show as more than text.
(define (textual? x)
  (or (in-notation? x) (number? x) (string? x) (boolean? x)
      (and (list? x) (andmap textual? x))))

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
