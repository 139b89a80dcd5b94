#lang racket/base
;; Racket's procedures that print, for values of ours: a program that displays a result shows
;; the same as the prompt, simplified and in lines, with the assumptions for that beneath.
;; Within the text of `format` and its kin a value is simplified, and stays on one line; as
;; nothing is told beneath, nothing is taken for granted.
;;
;; Other values are Racket's affair, and so is `write`, whose text is for programs to read.

(require "result.rkt"
         "../../algebra/expression/expression.rkt"
         "../../generic/cyclic-data.rkt" "../../generic/kind.rkt" "../../generic/naming.rkt"
         "../../value/assumptions.rkt" "../../value/simplify.rkt")

(provide (rename-out [show:display display] [show:displayln displayln]
                     [show:print print] [show:println println]
                     [show:printf printf] [show:eprintf eprintf]
                     [show:fprintf fprintf] [show:format format]))

;; ---------------------------------------------------------------------------
;; One value

(define line-width 79)

;; The value that Racket is to print in place of x.
(define (shown x) (if (plain? x) x (simplified-result x line-width)))

;; Nothing that could be simplified, at a glance.
(define (plain? x) (or (number? x) (string? x) (symbol? x) (boolean? x) (null? x) (char? x)))

;; (define-shown name print (argument ...) ...): for each list of further arguments a clause
(define-syntax-rule (define-shown name print (argument ...) ...)
  (define-named name print
    (case-lambda [(x argument ...) (print (shown x) argument ...)] ...)))

(define-shown show:display display () (port))
(define-shown show:displayln displayln () (port))
(define-shown show:print print () (port) (port depth))
(define-shown show:println println () (port) (port depth))

;; ---------------------------------------------------------------------------
;; Values within a text

(define (within-text x)
  (cond [(plain? x) x]
        [(or (node? x) (has-kind? x) (vector? x))
         (define-values (simple assumptions)
           (parameterize ([automatic-assumptions #f]) (as-shown x)))
         (if (unprintable? simple) (shown simple) simple)]
        [(pair? x) (cons (within-text (car x)) (within-text (cdr x)))]
        [(unprintable? x) (shown x)]
        [else x]))

;; For `format` and its kin.
(define (as-text x) (if (cyclic? x) x (within-text x)))

(define-syntax-rule (define-formatting name format)
  (define-named name format
    (lambda (text . xs) (apply format text (map as-text xs)))))

(define-formatting show:format format)
(define-formatting show:printf printf)
(define-formatting show:eprintf eprintf)
(define-named show:fprintf fprintf
  (lambda (port text . xs) (apply fprintf port text (map as-text xs))))
