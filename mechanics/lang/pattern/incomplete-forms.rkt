#lang racket/base
;; Definitions and procedures that lack a part, or have another form in the place of a name:
;; (define x), (define 3 x), (define L (m, k) 3), (lambda (* 2 t)), (define (f x, y) ...).

(require (only-in racket/list append-map first flatten last)
         "../written-form.rkt"
         "../../generic/on-demand.rkt"
         "../paper-notation/operation-sign.rkt" "../redefinition/definition-head.rkt")

(require-on-demand ["../paper-notation/definition-by-sign.rkt" procedure-elsewhere])

(provide check-complete-definition check-complete-procedure check-names)

;; stx : a form that begins with `define`
(define (check-complete-definition stx)
  (define (fail text . parts) (apply refuse stx #f text parts))
  (define d (syntax->datum stx))
  (syntax-case stx ()
    [(_) (fail "a definition is written (define x 3)")]
    [(_ head)
     (identifier? #'head)
     (fail "~a has no value; a definition is written (define ~a 3)" (cadr d) (cadr d))]
    [(_ head)
     (head-name-in (cadr d))
     (fail "no expressions for procedure body; it is written (define ~a (* 2 x))"
           (form->text (cadr d)))]
    [(_ head . _)
     (not (head-name-in (cadr d)))
     (fail (if (pair? (cadr d))
               "~a is no name; a function is defined as in (define (f x) (* 2 x))"
               "~a is no name; a definition is written (define x 3)")
           (form->text (first (flatten (cadr d)))))]
    [(_ head form more . others)
     (identifier? #'head)
     (fail "~a" (several-values d))]
    [_ (void)]))

;; d : (define L (m, k) 3), where (m k) may be meant for arguments; with a comma it is
(define (several-values d)
  (define arguments (caddr d))
  (define names (and (pair? arguments) (list? arguments) (without-commas arguments)))
  (define function
    (and names (andmap symbol? names)
         (form->text (list* 'define (cons (cadr d) names) (cdddr d)))))
  (cond [(and function (not (equal? names arguments)))
         (format "a definition is written ~a" function)]
        [(and (number? arguments) (decimal-part? (cadddr d)))
         (format "~a has one value, and a decimal has a point, as in 1.5" (cadr d))]
        [else
         (format "~a has one value, and here are several expressions~a" (cadr d)
                 (if function (format "; a function is written ~a" function) ""))]))

;; The part of 1,5 behind the comma
(define (decimal-part? d) (and (pair? d) (eq? 'unquote (car d)) (number? (cadr d))))

;; stx : a form that begins with `lambda`
(define (check-complete-procedure stx)
  (syntax-case stx ()
    [(_ form)
     (let ([d (syntax->datum #'form)])
       (if (formula? d)
           (refuse stx #f "the arguments come first: ~a"
                   (form->text `(lambda (,(first-letter (cdr d))) ,d)))
           (refuse stx #f "no expressions for procedure body; it is written (lambda ~a (* 2 t))"
                   (form->text d))))]
    [(_ name . body)
     (and (identifier? #'name) (procedure-elsewhere (syntax->list stx)))
     (refuse stx #f "arguments stand in parentheses: ~a"
             (form->text (procedure-elsewhere (syntax->list stx))))]
    [(_ name . body)
     (and (identifier? #'name) (before-colon (syntax-e #'name)))
     (refuse stx #f "arguments stand in parentheses: (lambda (~a) ...)"
             (before-colon (syntax-e #'name)))]
    [(_) (refuse stx #f "a function is written (lambda (t) (* 2 t))")]
    [_ (void)]))

(define (formula? d)
  (and (list? d) (pair? d) (pair? (cdr d))
       (memq (car d) (append '(+ - * / expt up down) functions))))

;; The letter that is likeliest the argument: t, or the last one
(define (first-letter ds)
  (define letters (append-map operands ds))
  (cond [(or (null? letters) (memq 't letters)) 't]
        [else (last letters)]))

;; ---------------------------------------------------------------------------
;; Argument lists

;; formals : an argument list of stx; written : datum -> the definition or procedure with these
;; formals
(define (check-names formals stx written)
  (define (fail at text . parts) (apply refuse stx at text parts))
  (let check ([formals* formals])
    (syntax-case formals* ()
      [((u name) . _)
       (eq? (syntax-e #'u) 'unquote)
       (fail (car (syntax-e formals*)) "no comma separates arguments: ~a"
             (form->text (written (without-commas (syntax->datum formals)))))]
      [(k . more)
       (keyword? (syntax-e #'k))
       (let ([name (keyword->string (syntax-e #'k))])
         (syntax-case #'more ()
           [(next . rest) (not (keyword? (syntax-e #'next))) (check #'rest)]
           [_ (fail #'k "a keyword is followed by a name: #:~a ~a" name name)]))]
      [(a . more)
       (begin
         (when (constant? (syntax-e #'a))
           (fail #'a "an argument is a name, which ~a is not" (form->text (syntax-e #'a))))
         (check #'more))]
      [_ (void)])))

(define (constant? x) (or (number? x) (string? x) (boolean? x) (char? x)))
