#lang racket/base
;; What forms look like where they were written.

(provide adjacent? prime-before? form->text without-commas)

;; Is there nothing between the two syntaxes?
(define (adjacent? one other)
  (and (equal? (syntax-source one) (syntax-source other)) (touch? one other)))

(define (touch? one other)
  (define-values (start span next)
    (values (syntax-position one) (syntax-span one) (syntax-position other)))
  (and start span next (= (+ start span) next)))

;; Does the second begin with a quote that touches the first, as in x't?
(define (prime-before? one other)
  (define d (syntax-e other))
  (and (pair? d) (eq? (syntax-e (car d)) 'quote) (adjacent? one other)))

;; A datum as it is typed, quotes as quotes.
(define (form->text d)
  (parameterize ([print-reader-abbreviations #t]) (format "~s" d)))

;; Data, of which f(x, y) has (x (unquote y)).
(define (without-commas data)
  (for/list ([d (in-list data)])
    (if (and (list? d) (= (length d) 2) (eq? (car d) 'unquote)) (cadr d) d)))
