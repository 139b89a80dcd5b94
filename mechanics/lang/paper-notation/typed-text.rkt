#lang racket/base
;; Forms that Racket read, as the text they were read from, for a reader of formulas: 1/2, *, m and
;; (x + 1) as "1/2 * m (x + 1)".
;;
;; A form of Racket's within a formula, 'x or (square v), is an operand: ⟪0⟫ stands for it.

(require (only-in racket/list last)
         (only-in racket/string string-join)
         "operation-sign.rkt"
         "../written-form.rkt"
         (only-in "../../algebra/notation/read-paper.rkt" function-named))

(provide typed-text)

;; forms : syntaxes, or data, which had spaces between
;; known? : symbol -> is it a name of something?
;; -> text or #f, and the operands of Racket's, ((⟪0⟫ . datum) ...)
(define (typed-text forms known?)
  (define operands '())
  (define (operand! datum)
    (define name (string->symbol (format "⟪~a⟫" (length operands))))
    (set! operands (cons (cons name datum) operands))
    (symbol->string name))
  (define text (let/ec give-up (row-text forms (writer known? operand! (lambda () (give-up #f))))))
  (values text operands))

;; give-up : for a form that is neither a formula's nor an operand
(struct writer (known? operand! give-up))

(define (row-text forms w)
  (apply string-append
         (for/list ([form (in-list forms)] [before (in-list (cons #f forms))])
           (define text (form-text form before w))
           (if (or (not before) (touches? before form) (regexp-match? #rx"^," text))
               text
               (string-append " " text)))))

(define (touches? before form) (and (syntax? before) (syntax? form) (adjacent? before form)))

(define (content form) (if (syntax? form) (syntax-e form) form))
(define (datum form) (if (syntax? form) (syntax->datum form) form))
(define (elements form)
  (define d (content form))
  (if (syntax? form) (syntax->list form) (and (list? d) d)))

;; before : the form before it, or #f
(define (form-text form before w)
  (define d (content form))
  (define parts (elements form))
  (cond [(symbol? d) (name-text form w)]
        [(number? d) (number-text form w)]
        [(not (and parts (pair? parts))) (if (null? parts) "()" ((writer-operand! w) (datum form)))]
        [(quotation? parts)
         (if (and before (touches? before form))
             (string-append "'" (if (touches? (car parts) (cadr parts)) "" " ")
                            (form-text (cadr parts) (car parts) w))
             ((writer-operand! w) (datum form)))]
        [(headed? parts 'unquote) (string-append "," (form-text (cadr parts) #f w))]
        [else (list-text form parts before w)]))

(define (headed? parts name) (and (eq? (content (car parts)) name) (= 2 (length parts))))
(define (quotation? parts) (headed? parts 'quote))

;; 6/2 is read as 3, but 6/2(a + b) is not clear.
(define (number-text form w)
  (define d (content form))
  (define text (number->string d))
  (if (and (exact? d) (syntax? form) (not (eqv? (syntax-span form) (string-length text))))
      ((writer-give-up w))
      text))

;; A backslash, of \alpha, is no part of the name that Racket reads; of more it is not known where
;; they stood.
(define (name-text form w)
  (define text (symbol->string (content form)))
  (define escapes (- (or (and (syntax? form) (syntax-span form)) (string-length text))
                     (string-length text)))
  (case escapes
    [(0) text]
    [(1) (regexp-replace #px"^(\\P{L}*)" text "\\1\\\\")]
    [else ((writer-give-up w))]))

;; ---------------------------------------------------------------------------
;; Lists

(define (list-text form parts before w)
  (define shape (and (syntax? form) (syntax-property form 'paren-shape)))
  (define (within open text close) (string-append open text close))
  (cond [(eqv? shape #\[) (within "[" (row-text parts w) "]")]
        [(eqv? shape #\{) (within "{" (row-text parts w) "}")]
        [(call-before before form) => (lambda (f) (within "(" (arguments-text f parts w) ")"))]
        [(formula? parts w) (within "(" (row-text parts w) ")")]
        [else (operand-text form parts w)]))

;; The name that ends before the parentheses and is called by them, or #f
(define (call-before before form)
  (define d (and before (content before)))
  (define word (and (symbol? d) (regexp-match #px"\\p{L}(?:\\p{L}|\\p{M}|[0-9_])*$" (symbol->string d))))
  (and word (or (touches? before form) (function-named (car word))) (car word)))

;; Without commas, several operands are a product where one argument is wanted.
(define (arguments-text f parts w)
  (cond [(signs-first? parts) (operand-text parts parts w)]
        [(or (function-named f) (ormap comma? parts) (signed? parts) (number? (content (car parts))))
         (row-text parts w)]
        [else (string-join (for/list ([p (in-list parts)]) (row-text (list p) w)) ", ")]))

(define (comma? part)
  (define parts (elements part))
  (and parts (pair? parts) (headed? parts 'unquote)))

;; Is it one by its signs, by a number or a name that is none of a function?
(define (formula? parts w)
  (define head (content (car parts)))
  (and (not (memq head with-operation))
       (not (signs-first? parts))
       (or (null? (cdr parts))
           (ormap comma? parts)
           (signed? parts)
           (number? head)
           (and (symbol? head)
                (not (function-named (symbol->string head)))
                (not ((writer-known? w) head))))))

;; Does a sign stand between them?
(define (signed? parts)
  (for/or ([p (in-list parts)])
    (and (sign? (content p)) (not (eq? p (last parts))))))

(define (signs-first? parts) (and (sign? (content (car parts))) (> (length parts) 2)))

;; (- k x) may be -k x or k - x.
(define (operand-text form parts w)
  (if (and (eq? (content (car parts)) '-) (> (length parts) 2))
      ((writer-give-up w))
      ((writer-operand! w) (if (pair? form) (map datum form) (datum form)))))
