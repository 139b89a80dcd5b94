#lang racket/base
;; Knowledge of the names in a formula, words cut into names, mgx as m, g, x, and functions as
;; other programs call them.

(require (only-in racket/list append-map range)
         (only-in "../../operation/operation-column.rkt" operation-names))

(provide (struct-out vocabulary) cuts-of function-named own-operations)

;; A vocabulary: the meanings of names.
;; name      : text -> the symbol that it is
;; quantity  : symbol -> datum that it stands for, or #f
;; function? : symbol -> is it the name of a function?
;; rate      : symbol, count of dots -> the datum of the rate, or #f
;; moving?   : datum -> is it that of a coordinate, or of a rate, which may have (t) behind it?
(struct vocabulary (name quantity function? rate moving?))

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

;; ---------------------------------------------------------------------------
;; Functions

;; -> symbol, or #f
(define (function-named text)
  (define name (string->symbol text))
  (cond [(memq name functions) name]
        [(assq name other-functions) => cdr]
        [else #f]))

(define functions (append '(square cube) (operation-names function reciprocal)))

(define other-functions
  '((ln . log) (arcsin . asin) (arccos . acos) (arctan . atan) (fabs . abs)
    (Sin . sin) (Cos . cos) (Tan . tan) (Sinh . sinh) (Cosh . cosh) (Tanh . tanh)
    (Exp . exp) (Log . log) (Sqrt . sqrt) (Abs . abs)
    (ArcSin . asin) (ArcCos . acos) (ArcTan . ArcTan)
    (pow . pow) (Power . Power) (atan2 . atan2) (log10 . log10)))

;; Functions of other programs, and powers of e, in ours.
(define (own-operations d known?)
  (if (pair? d)
      (let ([d (for/list ([part (in-list d)]) (own-operations part known?))])
        (case (car d)
          [(expt) (if (power-of-e? d known?) (list 'exp (caddr d)) d)]
          [(pow Power) (cons 'expt (cdr d))]
          [(atan2) (cons 'atan (cdr d))]
          [(ArcTan) (cons 'atan (reverse (cdr d)))]
          [(log10) (list 'log (cadr d) 10)]
          [else d]))
      d))

(define (power-of-e? d known?)
  (and (memq (cadr d) '(e E)) (not (known? (cadr d))) (not (number? (caddr d)))))
