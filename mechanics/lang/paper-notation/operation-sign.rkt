#lang racket/base
;; The signs of operations, which stand between operands on paper, and functions of one argument.

(require "../../operation/operation-column.rkt")

(provide sign? infix? with-operation formula-like? signed-name? functions about-formulas)

(define functions
  (append '(square cube) (operation-names function reciprocal)))

(define (sign? x) (and (memq x '(= < > <= >= + - * / ^ **)) #t))

;; Is a list of forms, data, a formula with a sign after its first operand?
(define (infix? forms)
  (and (pair? forms) (pair? (cdr forms))
       (not (sign? (car forms)))
       (not (memq (car forms) with-operation))
       (sign? (cadr forms))))

;; Procedures that an operation is given to, as in (apply + xs); some are of other languages.
(define with-operation
  '(apply map for-each foldl foldr fold fold-left fold-right reduce sort andmap ormap))

;; Does the name have operations of a formula in it, read or not: 2mgh, v^2/2k, x²?
(define (formula-like? d)
  (and (symbol? d)
       (regexp-match? like-formula (symbol->string d))))

(define like-formula
  (pregexp (string-append "^[-(]?(?:[0-9.]+\\p{L}|[^²³]+[²³]|.*[√·×⋅½⅓¼¾]|"
                          "(?:\\p{L}|[0-9_])+[*^/+](?:\\p{L}|[-0-9_(.]))")))

;; The same, or a sign at an end: m*, -x, ^2/2?
(define (signed-name? d)
  (or (formula-like? d)
      (and (symbol? d) (not (sign? d))
           (regexp-match? #px"^[-+*/^.]+(?:\\p{L}|[0-9(])|(?:\\p{L}|[0-9*/+])[*/+^-]$"
                          (symbol->string d)))))

;; Said of a formula that is not read.
(define about-formulas "operations come first, as in (* 2 x)")
