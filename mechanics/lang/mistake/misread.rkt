#lang racket/base
;; Calls that were meant otherwise, as far as the program itself shows it: formulas as on
;; paper, (m * v) and f(3), and brackets for tuples, [1 2].  All of them may be right, and are
;; expanded as what they are; what is said here is for the case that they fail.

(require (for-template "advised.rkt")
         "sign.rkt"
         "../as-written.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["infix.rkt" prefix-form])

(provide advice-on-call called-beside)

;; A call, and its operator and arguments, syntaxes -> text or #f
(define (advice-on-call stx row)
  (or (syntax-property stx called)
      (advice-on-infix row)
      (and (eqv? (syntax-property stx 'paren-shape) #\[)
           (format "brackets are parentheses here; a tuple is ~a"
                   (form->text (cons 'up (map syntax->datum row)))))
      (let ([f (syntax-e (car row))])
        (and (number? f) (null? (cdr row)) (format "f(~a) is written (f ~a)" f f)))))

(define (advice-on-infix row)
  (and (infix? (map syntax-e row))
       (let ([form (prefix-form (map syntax->datum row))])
         (if form
             (string-append "operations come first: " (form->text form))
             "operations come first, as in (* 2 x)"))))

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

(define (as-called f arguments)
  (define-values (name given) (values (syntax-e f) (syntax->datum arguments)))
  (format "~a~a is written ~a"
          name (form->text given) (form->text (cons name (without-commas given)))))

(define (without-commas arguments)
  (for/list ([a (in-list arguments)])
    (if (and (list? a) (= (length a) 2) (eq? (car a) 'unquote)) (cadr a) a)))
