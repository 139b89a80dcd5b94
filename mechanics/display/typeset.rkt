#lang racket/base
;; Values as formulas: the tree of a value, drawn in one of several ways.

(require "MathML.rkt" "TeX.rkt" "break.rkt" "drawn-text.rkt"
         "../algebra/notation/formula.rkt" "../algebra/notation/infix.rkt"
         "../algebra/notation/read-infix.rkt" "../algebra/notation/tree.rkt"
         "../error/complain.rkt"
         "../generic/define-plain.rkt" "../generic/value-tree.rkt"
         (only-in "../algebra/expression/write.rkt" datum->brief-text)
         "../value/read-expression.rkt" (only-in "../value/simplify.rkt" as-shown)
         (only-in "../verdict/verdict.rkt" verdict?))

(provide typeset-result ->infix ->text ->TeX ->MathML read-infix check-width)

;; On one line, in characters of Unicode.
(define (->infix x) (tree->line (value->tree x #f)))

;; In lines of text, fractions and roots drawn.
(define-plain (->text x #:width [width 80])
  (check-width '->text width)
  (tree->text (fit (value->tree x #t) width)))

;; For LaTeX's mathematics mode, with amsmath.
(define-plain (->TeX x #:width [width 80])
  (check-width '->TeX width)
  (tree->TeX (fit (value->tree x #t) width)))

(define-plain (->MathML x #:width [width 80] #:inline? [inline? #f])
  (check-width '->MathML width)
  (tree->MathML (fit (value->tree x #t) width) (not inline?)))

;; The value of a formula that is written as ->infix writes it.
(define (read-infix text)
  (unless (string? text)
    (raise-argument-error 'read-infix "a string such as \"½ m ẋ²\"" text))
  (read-expression (infix->datum text)))

;; A value, simplified as the prompt has it, in one of the formats; what that assumed and what
;; it left unexpanded is told beneath.
(define (typeset-result who x format)
  (unless (assq format drawings)
    (raise-argument-error who "a format: 'infix, 'text, 'TeX or 'MathML" format))
  (define-values (shown notes) (if (verdict? x) (values x '()) (as-shown x)))
  (define t (value->tree shown (not (eq? format 'infix))))
  ((cdr (assq format drawings)) (if (null? notes) t (with-notes t notes))))

(define drawings
  (list (cons 'infix tree->line)
        (cons 'text (lambda (t) (tree->text (fit t 79))))
        (cons 'TeX (lambda (t) (tree->TeX (fit t 79))))
        (cons 'MathML (lambda (t) (tree->MathML (fit t 79) #t)))))

(define (with-notes t notes)
  (report
   (cons (report-line 0 "" (list t))
         (for/list ([n (in-list notes)])
           (if (eq? (car n) 'left-unexpanded)
               (report-line 0 "; left unexpanded:" (list (plain (datum->brief-text (cadr n)))))
               (report-line 0 "; assuming" (list (plain-datum->tree n))))))))

(define (check-width who width)
  (unless (or (not width) (exact-positive-integer? width))
    (complain who "expected a width in columns, or #f for lines of any length\n  given: ~e" width)))
