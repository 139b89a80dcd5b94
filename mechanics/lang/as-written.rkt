#lang racket/base
;; What forms look like where they were written.

(provide adjacent? form->text without-commas)

;; Is there nothing between the two syntaxes?
(define (adjacent? one other)
  (define-values (start span next)
    (values (syntax-position one) (syntax-span one) (syntax-position other)))
  (and start span next (= (+ start span) next)))

;; A datum as it is typed, quotes as quotes.
(define (form->text d)
  (parameterize ([print-reader-abbreviations #t]) (format "~s" d)))

;; Data, of which f(x, y) has (x (unquote y)).
(define (without-commas data)
  (for/list ([d (in-list data)])
    (if (and (list? d) (= (length d) 2) (eq? (car d) 'unquote)) (cadr d) d)))
