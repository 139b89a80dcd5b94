#lang racket/base
;; Lines of several forms that were meant as one: f(3), sin x, x = 3, define m = 3.
;;
;; Each form would be evaluated by itself: f is printed, and then 3 cannot be applied.

(require racket/list
         "../as-written.rkt"
         "../mistake/misread.rkt" "../mistake/other-notation.rkt" "../mistake/prefix-form.rkt"
         "../mistake/sign.rkt"
         (only-in "../../generic/up-down.rkt" tuple?))

(provide meant-as-one prime-alone)

;; forms : of an entry, syntaxes -> what to say instead of evaluating them, or #f
(define (meant-as-one forms)
  (define data (map syntax->datum forms))
  (cond [(not (on-one-line? forms)) (call-beside forms)]
        [(definition-by-sign data) => (written "a definition is written ~a")]
        [(keyword? (car forms)) ((written "it stands in parentheses: ~a") (without-equals data))]
        [(and (infix? data) (prefix-form data)) => (written "operations come first: ~a")]
        [(call-beside forms)]
        [(prime? forms)
         (about-prime (car data))]
        [(and (pair? (cdr forms)) (names-procedure? (car forms)))
         ((written "a call stands in parentheses: ~a") data)]
        [else #f]))

(define ((written text) form) (format text (form->text form)))

(define (on-one-line? forms)
  (and (pair? forms)
       (for/and ([f (in-list (cdr forms))]) (eqv? (syntax-line f) (syntax-line (car forms))))))

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
;; x = 3, f(x) = x^2

;; -> the definition, a datum, or #f
(define (definition-by-sign data)
  (define i (index-where data (lambda (d) (memq d '(= :=)))))
  (define head (and i (head-before (take data i))))
  (define value (and head (pair? (drop data (add1 i))) (prefix-form (drop data (add1 i)))))
  (and value (list 'define head value)))

(define (head-before data)
  (cond [(and (= (length data) 1) (symbol? (car data))) (car data)]
        [(and (= (length data) 2) (symbol? (car data)) (list? (cadr data)))
         (cons (car data) (without-commas (cadr data)))]
        [else #f]))

;; ---------------------------------------------------------------------------
;; define m = 3, sin x

(define (keyword? form)
  (and (identifier? form)
       (memq (syntax-e form) '(define lambda λ let let* if cond require begin))
       #t))

(define (without-equals data)
  (define by-sign (definition-by-sign (cdr data)))
  (if (and (eq? (car data) 'define) by-sign) by-sign data))

(define (names-procedure? form)
  (and (identifier? form)
       (let ([x (namespace-variable-value (syntax-e form) #t (lambda () #f))])
         (and (procedure? x) (not (tuple? x))))))
