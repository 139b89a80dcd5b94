#lang racket/base
;; Forms that Racket read, as the text they were read from, for a reader of formulas: 1/2, *, m and
;; (x + 1) as "1/2 * m (x + 1)".
;;
;; A form of Racket's within a formula, 'x or (square v), is an operand: ⟪0⟫ stands for it.

(require (only-in racket/list last)
         (only-in racket/string string-join)
         "operation-sign.rkt"
         "../written-form.rkt"
         (only-in "../../algebra/notation/handwritten-words.rkt" function-named))

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
        [(headed? parts 'unquote) (string-append ", " (form-text (cadr parts) #f w))]
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
;; they stood, but at the prompt.
(define (name-text form w)
  (or (and (syntax? form) (typed-name form)) (name-as-read form w)))

(define (name-as-read form w)
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
        [else
         (case (sort-of parts w)
           [(formula) (within "(" (row-text parts w) ")")]
           [(call) ((writer-operand! w) (datum form))]
           [else ((writer-give-up w))])]))

;; The name that ends before the parentheses and is called by them, or #f
(define (call-before before form)
  (define d (and before (content before)))
  (define word
    (and (symbol? d) (regexp-match #px"\\p{L}(?:\\p{L}|\\p{M}|[0-9_])*$" (symbol->string d))))
  (and word (or (touches? before form) (function-named (car word))) (car word)))

;; Without commas, several operands are a product where one argument is wanted.
(define (arguments-text f parts w)
  (cond [(eq? (sort-of parts w) 'call) ((writer-operand! w) (map datum parts))]
        [(or (function-named f) (number? (content (car parts)))
             (ormap comma? parts) (signed? parts))
         (row-text parts w)]
        [else (string-join (map (lambda (run) (row-text run w)) (touching-runs parts)) ", ")]))

;; f(x) has two parts that touch.
(define (touching-runs parts)
  (define-values (runs run)
    (for/fold ([runs '()] [run (list (car parts))]) ([p (in-list (cdr parts))])
      (if (touches? (car run) p)
          (values runs (cons p run))
          (values (cons (reverse run) runs) (list p)))))
  (reverse (cons (reverse run) runs)))

(define (comma? part)
  (define parts (elements part))
  (and parts (pair? parts) (headed? parts 'unquote)))

;; Parts of a list in parentheses -> 'formula, 'call of Racket's, or #f where they may be either, as
;; (- k x), -k x or k - x
(define (sort-of parts w)
  (define head (content (car parts)))
  (define signs-first? (and (sign? head) (> (length parts) 2)))
  (define name? (and (symbol? head) (not (signed-name? head))))
  (cond [(or (memq head with-operation) (and signs-first? (not (eq? head '-)))) 'call]
        [signs-first? #f]
        [(or (null? (cdr parts)) (number? head)
             (ormap comma? parts) (signed? parts) (touching? parts))
         'formula]
        [(ormap (lambda (p) (signed-name? (content p))) parts) (if name? #f 'formula)]
        [name? (if (called? head w) 'call 'formula)]
        [(elements (car parts)) => (lambda (inner) (if (pair? inner) (sort-of inner w) 'formula))]
        [else 'formula]))

(define (called? name w)
  (or (function-named (symbol->string name))
      (and ((writer-known? w) name) (not (memq name '(I X))))))

(define (touching? parts) (ormap touches? parts (append (cdr parts) '(#f))))

;; Does a sign stand between them?
(define (signed? parts)
  (for/or ([p (in-list parts)])
    (and (sign? (content p)) (not (eq? p (last parts))))))
