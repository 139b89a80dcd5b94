#lang racket/base
;; Lines of several forms that were meant as one, f(3), sin x, x = 3, define m = 3; and lines that
;; were printed, not typed.
;;
;; Each form would be evaluated by itself: f is printed, and then 3 cannot be applied.

(require racket/list
         "definition-by-sign.rkt" "misread.rkt" "other-notation.rkt" "prefix-form.rkt" "sign.rkt"
         "../as-written.rkt")

(provide meant-as-one misread-line prime-alone)

;; forms     : of an entry, syntaxes
;; known?    : symbol -> is anything known of the name?
;; function? : symbol -> is it the name of a function?
;; -> what to say instead of evaluating them, or #f
(define (meant-as-one forms known? function?)
  (define data (map syntax->datum forms))
  (cond [(not (on-one-line? forms)) (call-beside forms)]
        [(printed data known?)]
        [(definition-by-sign data known?)
         => (lambda (form)
              (if (Lagrangian-by-sign? form)
                  ((written "a Lagrangian is a function of (up t q v): ~a") form)
                  ((written "a definition is written ~a") form)))]
        [(keyword? (car data)) ((written "it stands in parentheses: ~a") (without-equals data))]
        [(and (infix? data) (prefix-form data)) => (written "operations come first: ~a")]
        [(call-beside forms)]
        [(prime? forms)
         (about-prime (car data))]
        [(and (pair? (cdr forms)) (symbol? (car data)) (function? (car data)))
         ((written "a call stands in parentheses: ~a") data)]
        [else #f]))

;; Of the forms of a program, the first of a line that was meant as one, and what to say; or #f
(define (misread-line forms known? function?)
  (for/or ([line (in-list (by-line forms))])
    (define text (and (pair? (cdr line)) (meant-as-one line known? function?)))
    (and text (cons (car line) text))))

(define (by-line forms) (group-by syntax-line (filter syntax-line forms)))

(define ((written text) form) (format text (form->text form)))

(define (on-one-line? forms)
  (and (pair? forms)
       (for/and ([f (in-list (cdr forms))]) (eqv? (syntax-line f) (syntax-line (car forms))))))

;; "proved: the residual is zero", "> (+ 1 2)"
(define (printed data known?)
  (define first-one (car data))
  (cond [(or (null? (cdr data)) (not (symbol? first-one))) #f]
        [(eq? first-one '>) (format "> is the prompt's, not part of what is typed: ~a"
                                    (form->text (cadr data)))]
        [(and (regexp-match? #px"\\p{L}:$" (symbol->string first-one)) (not (known? first-one)))
         (format "~a ... is a line that was printed, nothing to type" first-one)]
        [(and (> (length data) 3) (andmap symbol? data) (not (infix? data))
              (not (ormap known? data)))
         (format "no name in this line is known; a form stands in parentheses, as (f ~a)"
                 first-one)]
        [else #f]))

;; f(3); of what is no name, as sin^2, its evaluation says more.
(define (call-beside forms)
  (for/or ([f (in-list forms)] [next (in-list (if (pair? forms) (cdr forms) '()))])
    (and (call-in-print? f next)
         (not (notation-sentence (syntax-e f)))
         (as-called f next))))

;; text : of an unfinished entry -> what to say of x', or #f
(define (prime-alone text)
  (define found (regexp-match #px"^\\s*([^\\s()\\[\\]\"';`,#|]+)'+\\s*$" text))
  (and found (about-prime (cadr found))))

(define (about-prime name)
  (format "a prime is read as a quote; the derivative of ~a is (D ~a)" name name))

(define (prime? forms)
  (and (= (length forms) 2)
       (identifier? (car forms))
       (adjacent? (car forms) (cadr forms))
       (let ([next (syntax-e (cadr forms))])
         (and (pair? next) (eq? (syntax-e (car next)) 'quote)))))

;; ---------------------------------------------------------------------------
;; define m = 3

(define (keyword? datum) (and (memq datum '(define lambda λ let let* if cond require begin)) #t))

(define (without-equals data)
  (define by-sign (plain-definition (cdr data)))
  (if (and (eq? (car data) 'define) by-sign) by-sign data))
