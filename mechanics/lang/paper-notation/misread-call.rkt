#lang racket/base
;; Calls that were meant otherwise, as far as the program itself shows it: formulas as on
;; paper, (m * v) and f(3), and brackets for tuples, [1 2].  All of them may be right, and are
;; expanded as calls; the advice is for the case that they fail.
;;
;; Some calls can have no meaning, and are refused: keywords without their values,
;; (evolve-trajectory f state 10 #:tolerance); and quotes that touch the form before them,
;; (+ 1 2'x) and (x' t), which are read as (+ 1 2 'x) and (x 't).

(require (for-template "expansion-advice.rkt")
         "operation-sign.rkt"
         "../written-form.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["prefix-form.rkt" prefix-form])

(provide check-call keyword-argument? advice-on-call advice-on-product called-beside
         call-in-print? as-called)

;; ---------------------------------------------------------------------------
;; Calls without meaning

;; stx : of #%app
(define (check-call stx)
  (define row (cdr (or (syntax->list stx) '(#f))))
  (check-keywords stx (if (null? row) '() (cdr row)))
  (check-quotes stx row))

(define (refuse-call stx text . operands)
  (apply refuse (datum->syntax stx (cdr (syntax-e stx)) stx) #f text operands))

(define (keyword-argument? stx) (keyword? (syntax-e stx)))

(define (check-keywords stx arguments)
  (let check ([parts arguments])
    (cond [(null? parts) (void)]
          [(not (keyword-argument? (car parts))) (check (cdr parts))]
          [(or (null? (cdr parts)) (keyword-argument? (cadr parts)))
           (refuse-call stx "~s has no value: it stands behind the keyword" (syntax-e (car parts)))]
          [else (check (cddr parts))])))

(define (check-quotes stx row)
  (for ([one (in-list row)] [next (in-list (if (null? row) '() (cdr row)))])
    (define d (syntax-e one))
    (when (and (or (symbol? d) (number? d)) (prime-before? one next))
      (if (number? d)
          (refuse-call stx "~a~a is read as two; a product is ~a" d
                       (form->text (syntax->datum next))
                       (form->text (list '* d (syntax->datum next))))
          (refuse-call stx "~a" (about-prime d))))))

;; ---------------------------------------------------------------------------
;; Advice

;; A call, and its operator and arguments, syntaxes -> text or #f.  Advice on the formula around a
;; formula holds for it, too.
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
       (let ([form (prefix-form row (bound-beside (car row)))])
         (if form
             (string-append "operations come first: " (form->text form) (or-definition form))
             about-formulas))))

;; Is the name bound where the form stands?
(define ((bound-beside stx) name) (and (identifier-binding (datum->syntax stx name)) #t))

(define (or-definition form)
  (if (and (eq? (car form) '=) (symbol? (cadr form)))
      (format "; a definition is ~a" (form->text (cons 'define (cdr form))))
      ""))

;; For an unknown name in the formula: where all are known, the refusal shows their values.
(define (advice-on-product row)
  (define form (and (formula? row) (prefix-form row (bound-beside (car row)))))
  (and form (string-append "a product is " (form->text form))))

(define (advice-on-brackets stx row)
  (define shape (syntax-property stx 'paren-shape))
  (and (memv shape '(#\[ #\{))
       (format "~a are parentheses here; a tuple is ~a"
               (if (eqv? shape #\[) "brackets" "braces")
               (form->text (cons 'up (map syntax->datum row))))))

;; ---------------------------------------------------------------------------
;; f(x), which is read as f and the call (x) behind it

(define called 'mechanics:called)

;; Syntaxes in a row: each name and list that touch are marked with the call in prefix form.
(define (called-beside row)
  (for/list ([stx (in-list row)]
             [before (in-list (cons #f row))]
             [after (in-list (append (cdr row) '(#f)))])
    (cond [(and before (call-in-print? before stx))
           (syntax-property stx called (as-called before stx (bound-beside stx)))]
          [(and after (call-in-print? stx after))
           (with-advice stx (as-called stx after (bound-beside stx)))]
          [else stx])))

(define (call-in-print? name arguments)
  (and (identifier? name) (parenthesized? arguments) (adjacent? name arguments)))

(define (parenthesized? stx)
  (and (list? (syntax->list stx))
       (memv (syntax-property stx 'paren-shape) '(#f #\())
       (not (memq (and (pair? (syntax-e stx)) (syntax-e (car (syntax-e stx))))
                  '(quote quasiquote unquote)))))

;; A name and the list that touches it, f(x + 1) -> "f(x + 1) is written (f (+ x 1))"
(define (as-called f arguments known?)
  (define form (prefix-form (list f arguments) known?))
  (define name (syntax-e f))
  (if (or form (memq name functions) (known? name))
      (format "~a~a is written ~a"
              name (typed-text arguments) (form->text (or form (list name '...))))
      about-formulas))

;; The text in the program, without spaces at the ends.
(define (typed-text stx)
  (define parts (syntax->list stx))
  (cond [(not (and parts (parenthesized? stx))) (form->text (syntax->datum stx))]
        [else
         (define texts
           (for/list ([p (in-list parts)] [before (in-list (cons #f parts))])
             (string-append (if (and before (not (adjacent? before p))) " " "") (typed-text p))))
         (format "(~a)" (apply string-append texts))]))
