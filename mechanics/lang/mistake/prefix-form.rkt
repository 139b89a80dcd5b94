#lang racket/base
;; Formulas written with their operations between the operands, as on paper: how they are
;; written here.
;;
;; The forms of a list are read as operands and signs in turn.  Two operands without a sign
;; are multiplied, and a name before parentheses is called; powers bind closest, then products,
;; then sums, then comparisons.  What is left of a sign is taken together first, but for powers.

(require racket/list
         "sign.rkt" "typed-formula.rkt")

(provide prefix-form)

;; Signs from the loosest to the closest, and how the operation is called here.
(define levels
  '(((= . =) (< . <) (> . >) (<= . <=) (>= . >=))
    ((+ . +) (- . -))
    ((* . *) (/ . /))
    ((^ . expt) (** . expt))))

;; -> the form to write instead, a datum, or #f
(define (prefix-form forms) (at-level (with-calls forms) levels))

;; ---------------------------------------------------------------------------

(define (at-level forms levels)
  (cond [(null? forms) #f]
        [(null? levels) (product forms)]
        [(null? (cdr levels)) (power forms (car levels))]
        [else (chain forms (car levels) (cdr levels))]))

;; Split at the last sign of the level; what is left of it is of the level, too.
(define (chain forms level closer)
  (define i (last-index-where forms (lambda (d) (assq d level))))
  (cond [(not i) (at-level forms closer)]
        [else
         (define name (cdr (assq (list-ref forms i) level)))
         (define left (chain (take forms i) level closer))
         (define right (at-level (drop forms (add1 i)) closer))
         (and left right (operation name left right))]))

(define (last-index-where forms wanted?)
  (define places (indexes-where forms wanted?))
  (and (pair? places) (last places)))

;; Split at the first sign.
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
  (cond [(not (andmap values operands)) #f]
        [(null? operands) #f]
        [(null? (cdr operands)) (car operands)]
        [else (foldl (lambda (next all) (operation '* all next)) (car operands) (cdr operands))]))

;; Sums and products take any number of operands.
(define (operation name left right)
  (if (and (memq name '(+ *)) (pair? left) (eq? (car left) name))
      (append left (list right))
      (list name left right)))

(define (operand d)
  (cond [(sign? d) #f]
        [(symbol? d) (formula-of d)]
        [(and (list? d) (infix? d)) (prefix-form d)]
        [else d]))

(define (formula-of name)
  (define text (typed-formula name))
  (if text (read (open-input-string text)) name))

;; sin (x) is a call, as long as (x) is no formula.
(define (with-calls forms)
  (cond [(or (null? forms) (null? (cdr forms))) forms]
        [(and (symbol? (car forms)) (not (sign? (car forms)))
              (argument-list? (cadr forms)))
         (with-calls (cons (cons (car forms) (cadr forms)) (cddr forms)))]
        [else (cons (car forms) (with-calls (cdr forms)))]))

(define (argument-list? d)
  (and (list? d) (not (infix? d)) (not (memq (if (pair? d) (car d) #f) '(quote quasiquote)))))
