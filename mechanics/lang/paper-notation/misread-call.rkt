#lang racket/base
;; Calls that were meant otherwise, as far as the program itself shows it: formulas as on
;; paper, (m * v) and f(3), and brackets for tuples, [1 2].  All of them may be right, and are
;; expanded as what they are; what is said here is for the case that they fail.

(require (for-template "expansion-advice.rkt")
         "operation-sign.rkt"
         "../written-form.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["prefix-form.rkt" prefix-form call-form])

(provide advice-on-call advice-on-product called-beside call-in-print? as-called)

;; A call, and its operator and arguments, syntaxes -> text or #f.  Within a formula that has
;; advice on it, that holds for what is written so, too.
(define (advice-on-call stx row)
  (or (syntax-property stx called)
      (and (formula? row) (advice-on stx))
      (advice-on-infix row)
      (advice-on-brackets stx row)
      (and (null? (cdr row)) (number? (syntax-e (car row)))
           (let ([f (syntax-e (car row))])
             (format "a number is written ~a, without parentheses; f(~a) is written (f ~a)"
                     f f f)))))

;; (m * v), and (1/2 m v) in which a number is applied
(define (formula? row)
  (define data (map syntax-e row))
  (or (infix? data) (and (number? (car data)) (pair? (cdr data)))))

(define (advice-on-infix row)
  (and (infix? (map syntax-e row))
       (let ([form (prefix-form (map syntax->datum row))])
         (if form
             (string-append "operations come first: " (form->text form) (or-definition form))
             "operations come first, as in (* 2 x)"))))

(define (or-definition form)
  (if (and (eq? (car form) '=) (symbol? (cadr form)))
      (format "; a definition is ~a" (form->text (cons 'define (cdr form))))
      ""))

;; For whoever finds a name in it unknown: where all are known, the refusal shows their values.
(define (advice-on-product row)
  (define form (and (formula? row) (prefix-form (map syntax->datum row))))
  (and form (string-append "a product is " (form->text form))))

(define (advice-on-brackets stx row)
  (define shape (syntax-property stx 'paren-shape))
  (and (memv shape '(#\[ #\{))
       (format "~a are parentheses here; a tuple is ~a"
               (if (eqv? shape #\[) "brackets" "braces")
               (form->text (cons 'up (map syntax->datum row))))))

;; ---------------------------------------------------------------------------
;; f(x), which is read as f and, beside it, the call (x)

(define called 'mechanics:called)

;; Syntaxes that stand in a row, each name and list that touch marked with how that call is
;; written.
(define (called-beside row)
  (for/list ([stx (in-list row)]
             [before (in-list (cons #f row))]
             [after (in-list (append (cdr row) '(#f)))])
    (cond [(and before (call-in-print? before stx))
           (syntax-property stx called (as-called before stx))]
          [(and after (call-in-print? stx after)) (with-advice stx (as-called stx after))]
          [else stx])))

(define (call-in-print? name arguments)
  (and (identifier? name) (parenthesized? arguments) (adjacent? name arguments)))

(define (parenthesized? stx)
  (and (list? (syntax->list stx))
       (memv (syntax-property stx 'paren-shape) '(#f #\())
       (not (memq (if (pair? (syntax-e stx)) (syntax-e (car (syntax-e stx))) #f)
                  '(quote quasiquote unquote)))))

;; f(x + 1), a name and what touches it -> "f(x + 1) is written (f (+ x 1))"
(define (as-called f arguments)
  (format "~a~a is written ~a"
          (syntax-e f) (typed-text arguments) (form->text (called-form f arguments))))

(define (called-form f arguments)
  (call-form (syntax-e f) (argument-forms (syntax->list arguments))))

;; Data of syntaxes in a row, calls among them being taken together.
(define (argument-forms row)
  (cond [(null? row) '()]
        [(and (pair? (cdr row)) (call-in-print? (car row) (cadr row)))
         (cons (called-form (car row) (cadr row)) (argument-forms (cddr row)))]
        [else (cons (syntax->datum (car row)) (argument-forms (cdr row)))]))

;; As it stands in the program, but for spaces at the ends.
(define (typed-text stx)
  (define parts (syntax->list stx))
  (cond [(not (and parts (parenthesized? stx))) (form->text (syntax->datum stx))]
        [else
         (apply string-append
                "("
                (append (for/list ([p (in-list parts)]
                                   [before (in-list (cons #f parts))])
                          (string-append (if (and before (not (adjacent? before p))) " " "")
                                         (typed-text p)))
                        '(")")))]))
