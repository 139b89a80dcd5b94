#lang racket/base
;; Formulas with their operations between the operands, as on paper, in prefix form.
;;
;; The forms of a list are read as operands and signs in turn.  Two operands without a sign
;; are multiplied, and a name before parentheses is called; powers bind closest, then products,
;; then sums, then comparisons.  Operations associate to the left, powers to the right.
;; The argument of a function such as cos is the content of the parentheses behind it, or else the
;; next operand.

(require racket/list
         "operation-sign.rkt" "typed-formula.rkt"
         "../written-form.rkt")

(provide prefix-form call-form sign-at-end operand-in)

;; Signs from the loosest to the closest, with the names of their operations.
(define levels
  '(((= . =) (< . <) (> . >) (<= . <=) (>= . >=))
    ((+ . +) (- . -))
    ((* . *) (/ . /))
    ((^ . expt) (** . expt))))

;; -> the form to write instead, a datum, or #f
(define (prefix-form forms) (at-level (with-calls (apart forms)) levels))

;; ---------------------------------------------------------------------------

(define (at-level forms levels)
  (cond [(null? forms) #f]
        [(null? levels) (product forms)]
        [(null? (cdr levels)) (power forms (car levels))]
        [else (chain forms (car levels) (cdr levels))]))

;; Splits at the last sign of the level; the part left of it may have signs of the level, too.
(define (chain forms level closer)
  (define places (indexes-where forms (lambda (d) (assq d level))))
  (cond [(null? places) (at-level forms closer)]
        [else
         (define i (last places))
         (define name (cdr (assq (list-ref forms i) level)))
         (define left (chain (take forms i) level closer))
         (define right (at-level (drop forms (add1 i)) closer))
         (and left right (operation name left right))]))

;; Splits at the first sign.
(define (power forms level)
  (define i (index-where forms (lambda (d) (assq d level))))
  (cond [(not i) (product forms)]
        [else
         (define base (product (take forms i)))
         (define exponent (power (drop forms (add1 i)) level))
         (and base exponent (of-last base exponent))]))

;; In 2 x ^ 3 it is x that is raised.
(define (of-last base exponent)
  (if (and (pair? base) (eq? (car base) '*))
      (append (drop-right base 1) (list (list 'expt (last base) exponent)))
      (list 'expt base exponent)))

(define (product forms)
  (define operands (map operand forms))
  (and (pair? operands)
       (andmap values operands)
       (foldl (lambda (next all) (operation '* all next)) (car operands) (cdr operands))))

;; Sums, products and comparisons take any number of operands.
(define (operation name left right)
  (if (and (memq name '(+ * = < > <= >=)) (pair? left) (eq? (car left) name))
      (append left (list right))
      (list name left right)))

(define (operand d)
  (cond [(sign? d) #f]
        [(symbol? d) (formula-of d)]
        [(and (list? d) (formula? d)) (prefix-form d)]
        [else d]))

;; Is it a formula in parentheses, with a sign, or a number before its factor?
(define (formula? forms)
  (or (infix? forms)
      (and (pair? forms)
           (if (null? (cdr forms))
               (and (symbol? (car forms)) (typed-formula (car forms)) #t)
               (number? (car forms))))))

(define (formula-of name)
  (define text (typed-formula name))
  (cond [text (read (open-input-string text))]
        [(memq name '(deg degree degrees °)) '(/ pi 180)]
        [else name]))

;; ---------------------------------------------------------------------------
;; Calls

;; A*cos (omega t) is A * cos (omega t), and p/ (2 m) is p / (2 m).
(define (apart forms)
  (append-map (lambda (form next) (if (list? next) (function-apart form) (list form)))
              forms
              (cdr (append forms '(#f)))))

(define (function-apart d)
  (define found (and (symbol? d) (regexp-match #px"^(.+)([-+*/])(\\p{L}+)$" (symbol->string d))))
  (define name (and found (string->symbol (cadddr found))))
  (cond [(and name (one-argument-function? name))
         (list (operand-in (cadr found)) (string->symbol (caddr found)) name)]
        [(sign-at-end d)
         => (lambda (found) (list (operand-in (cadr found)) (string->symbol (caddr found))))]
        [else (list d)]))

;; p^2/ -> ("p^2/" "p^2" "/"), or #f
(define (sign-at-end d)
  (and (symbol? d) (regexp-match #px"^(.*(?:\\p{L}|[0-9]))([-+*/^])$" (symbol->string d))))

(define (operand-in text) (or (string->number text) (string->symbol text)))

;; sin (x) is a call, and so is f (x) as long as (x) is no formula.
(define (with-calls forms)
  (cond [(or (null? forms) (null? (cdr forms))) forms]
        [(or (function-before? (car forms) (cadr forms)) (call-before? (car forms) (cadr forms)))
         (cons (call-form (car forms) (behind (cadr forms))) (with-calls (cddr forms)))]
        [else (cons (car forms) (with-calls (cdr forms)))]))

(define (function-before? name next) (and (one-argument-function? name) (not (sign? next))))

(define (call-before? name next)
  (and (symbol? name) (not (sign? name)) (not (memq name '(pi :pi)))
       (list? next) (not (formula? next)) (not (written-call? next))))

;; The arguments of a function, by the form behind it: its elements, unless the form is a call in
;; prefix form, as in (sin (square x)).
(define (behind d) (if (and (list? d) (not (written-call? d))) d (list d)))

(define (written-call? d)
  (and (pair? d)
       (or (one-argument-function? (car d)) (sign? (car d)) (memq (car d) '(quote quasiquote)))
       #t))

;; name (arguments), data -> the call.  Without commas, several operands are a product where one
;; argument is wanted.
(define (call-form name arguments)
  (define plain (without-commas arguments))
  (define single (and (one-argument-function? name) (equal? plain arguments)))
  (define whole
    (cond [(and single (written-call? plain)) plain]
          [(and (pair? plain) (or single (formula? plain))) (prefix-form plain)]
          [else #f]))
  (cons name (if whole (list whole) (map (lambda (d) (or (operand d) d)) plain))))

(define (one-argument-function? name) (and (memq name functions) #t))
