#lang racket/base
;; What is known of the names in a formula, and words cut into names: mgx as m, g, x.

(require (only-in racket/list append-map range))

(provide (struct-out vocabulary) cuts-of)

;; What is known of names.
;; quantity  : symbol -> datum that it stands for, or #f
;; function? : symbol -> is it the name of a function?
;; rate      : symbol, count of dots -> the datum of the rate, or #f
;; moving?   : datum -> is it that of a coordinate, or of a rate, which may have (t) behind it?
(struct vocabulary (quantity function? rate moving?))

;; known? : text -> is it a name?  -> the ways to cut the text into names, two at most; without the
;; text as a whole
(define (cuts-of text known?)
  (define n (string-length text))
  (define memo (make-hasheqv (list (cons n '(())))))
  (define (cuts from)
    (hash-ref! memo from (lambda () (few (append-map (cut-at from) (ends from))))))
  (define (ends from) (range (+ 1 from) (min (+ 1 n) (+ from longest-piece))))
  (define ((cut-at from) to)
    (define piece (substring text from to))
    (if (known? piece) (map (lambda (rest) (cons piece rest)) (cuts to)) '()))
  (filter (lambda (pieces) (pair? (cdr pieces))) (cuts 0)))

(define longest-piece 20)

(define (few cuts) (if (and (pair? cuts) (pair? (cdr cuts))) (list (car cuts) (cadr cuts)) cuts))
