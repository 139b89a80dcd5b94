#lang racket/base
;; Lines of several forms that were meant as one, f(3), sin x, x = 3, define m = 3; and printed
;; lines, which were pasted.
;;
;; Each form would be evaluated by itself: f is printed, and then 3 cannot be applied.

(require racket/list
         "definition-by-sign.rkt" "misread-call.rkt" "other-notation.rkt" "prefix-form.rkt"
         "operation-sign.rkt"
         "../written-form.rkt"
         (only-in "../../algebra/notation/handwritten-words.rkt" function-named))

(provide meant-as-one misread-line prime-alone)

;; forms     : of an entry, syntaxes
;; known?    : symbol -> is anything known of the name?
;; function? : symbol -> is it the name of a function?
;; -> advice in place of their evaluation, or #f
(define (meant-as-one forms known? function?)
  (define data (map syntax->datum forms))
  (cond [(null? forms) #f]
        [(not (on-one-line? forms)) (call-beside forms known?)]
        [(printed data known?)]
        [(and (not (ormap TeX? forms)) (in-other-words data known?))]
        [(several-definitions? data)
         "no comma separates definitions; each has a line of its own, as (define x 3)"]
        [(definition-by-sign forms known?)
         => (lambda (form)
              (define state (state-by-sign form))
              ((written (if state (string-append state ": ~a") "a definition is written ~a"))
               form))]
        [(procedure-elsewhere forms known?) => (written "a function is written ~a")]
        [(null? (cdr data)) (about-escapes (car forms))]
        [(keyword? (car data)) ((written "it stands in parentheses: ~a") data)]
        [(and (null? (cddr data))
              (or (not (signed-name? (car data))) (notation-sentence (car data)))
              (call-beside forms known?))]
        [(formula-beside forms known?)]
        [(bracketed-call forms known?)]
        [(component-beside forms)]
        [(call-beside forms known?)]
        [(prime? forms) (about-prime (car data))]
        [(and (symbol? (car data)) (function? (car data)) (call-data? data))
         ((written "a call stands in parentheses: ~a") data)]
        [else #f]))

;; forms : of a program -> the first form of a line that was meant as one, and advice; or #f
(define (misread-line forms known? function?)
  (for/or ([line (in-list (by-line forms))])
    (define text (and (pair? (cdr line)) (meant-as-one line known? function?)))
    (and text (cons (car line) text))))

(define (by-line forms) (group-by syntax-line (filter syntax-line forms)))

(define ((written text) form) (format text (form->text form)))

(define (on-one-line? forms)
  (and (pair? forms)
       (for/and ([f (in-list (cdr forms))]) (eqv? (syntax-line f) (syntax-line (car forms))))))

;; "proved: the residual is zero", "zero if: k = 3", "> (+ 1 2)"
(define (printed data known?)
  (define first-one (car data))
  (define (label? d)
    (and (symbol? d) (regexp-match? #px"\\p{L}:$" (symbol->string d)) (not (known? d))))
  (cond [(or (null? (cdr data)) (not (symbol? first-one)) (memq first-one '(def lambda))) #f]
        [(eq? first-one '>) (format "> is the prompt's, not part of what is typed: ~a"
                                    (form->text (cadr data)))]
        [(memq first-one '(// /* /** % %% -- !)) "a comment begins with a semicolon"]
        [(or (label? first-one) (and (label? (cadr data)) (not (known? first-one))))
         (format "~a ... is a line that was printed, nothing to type" first-one)]
        [else #f]))

;; a, b = 1, 2
(define (several-definitions? data)
  (and (ormap comma? data)
       (regexp-match? #rx"=" (format "~a" data))
       (not (memq 'lambda data))))

(define (comma? d) (and (pair? d) (eq? (car d) 'unquote)))

;; import math; and a line of prose
(define (in-other-words data known?)
  (define advice (and (symbol? (car data)) (notation-sentence (car data))))
  (cond [(not (and (pair? (cdr data)) (andmap symbol? data) (not (infix? data)))) #f]
        [advice (format "~a: ~a" (car data) advice)]
        [(and (> (length data) 3) (not (ormap known? data)) (ormap word? data))
         (format "no name in this line is known; a form stands in parentheses, as (f ~a)"
                 (car data))]
        [else #f]))

;; 1/2 m v^2, and m v^2/2k, which has two meanings.  Names that are known may stand in a row.
(define (formula-beside forms known?)
  (define data (map syntax->datum forms))
  (define form
    (and (or (ormap sign? (cdr data))
             (ormap TeX-like? forms)
             (goes-on? forms)
             (prime-within? forms)
             (and (ormap (lambda (d) (with-unknown? d known?)) data)
                  (not (ormap (lambda (d) (racket-form? d known?)) data))))
         (prefix-form forms known?)))
  (cond [(and form (advice-to-write form))]
        [(or (infix? data) (ormap signed-name? data) (ormap TeX-like? forms) (goes-on? forms))
         about-formulas]
        [else #f]))

;; m x'^2
(define (prime-within? forms)
  (for/or ([f (in-list forms)] [next (in-list (cdr forms))])
    (and (identifier? f) (prime-before? f next))))

;; Does a form touch the arguments of a call, as in f(x)g(x)?
(define (goes-on? forms)
  (and (pair? forms) (pair? (cdr forms)) (pair? (cddr forms))
       (or (and (call-in-print? (car forms) (cadr forms)) (adjacent? (cadr forms) (caddr forms)))
           (goes-on? (cdr forms)))))

;; Is it an unknown name, or a formula in parentheses?
(define (with-unknown? d known?)
  (or (and (symbol? d) (not (known? d)))
      (and (pair? d) (list? d)
           (or (infix? d) (and (formula-like? (car d)) (not (known? (car d))))))))

;; (define x 3) and x beside it are two forms.
(define (racket-form? d known?)
  (and (pair? d) (symbol? (car d)) (known? (car d)) (pair? (cdr d)) (not (infix? d))))

;; TeX's braces, and its commands
(define (braces? form) (eqv? (syntax-property form 'paren-shape) #\{))
(define (TeX? form) (and (identifier? form) (typed-name form) #t))
(define (TeX-like? form) (or (braces? form) (TeX? form)))

;; A word of prose, as no letter of a formula is
(define (word? d) (regexp-match? #px"^\\p{L}{2,}[.,]?$" (symbol->string d)))

;; D[Sin[x], x], Solve[x^2 == 1, x], as Mathematica has them
(define (bracketed-call forms known?)
  (define name (syntax-e (car forms)))
  (define advice (and (symbol? name) (bracket-beside forms) (notation-sentence name)))
  (cond [(and (eq? name 'D) (bracket-beside forms))
         => (lambda (parts) (derivative-of parts known?))]
        [advice (format "~a: ~a" name advice)]
        [else #f]))

(define (derivative-of parts known?)
  (define-values (before behind) (splitf-at parts (lambda (p) (not (comma? (syntax->datum p))))))
  (define form (and (pair? before) (prefix-form before known?)))
  (define x (and (= (length behind) 1) (cadr (syntax->datum (car behind)))))
  (if (and form (symbol? x))
      ((written "a derivative is that of a function: ~a") `((D (lambda (,x) ,form)) ',x))
      "the derivative of a function f is (D f), a partial one ((partial 0) f)"))

;; The parts of the bracket that touches the first form, or #f
(define (bracket-beside forms)
  (define bracket (and (= (length forms) 2) (cadr forms)))
  (and bracket
       (eqv? (syntax-property bracket 'paren-shape) #\[)
       (adjacent? (car forms) bracket)
       (pair? (syntax-e bracket))
       (syntax->list bracket)))

;; x[0]
(define (component-beside forms)
  (define indices (bracket-beside forms))
  (and indices
       (format "a component is ~a"
               (form->text (list* 'ref (map syntax->datum (cons (car forms) indices)))))))

;; f(3); for sin^2 (x) advice on the power
(define (call-beside forms known?)
  (for/or ([f (in-list forms)] [next (in-list (if (pair? forms) (cdr forms) '()))])
    (and (call-in-print? f next)
         (let ([advice (and (not (function-named (symbol->string (syntax-e f))))
                            (notation-sentence (syntax-e f)))])
           (if advice (format "~a: ~a" (syntax-e f) advice) (as-called f next known?))))))

;; text : of an unfinished entry -> advice on x', or #f
(define (prime-alone text)
  (define found
    (regexp-match #px"^(?:[^()\\[\\]\"`;#|]*\\s)?('?)([^\\s()\\[\\]\"';`,#|]+)'+\\s*$" text))
  (cond [(not found) #f]
        [(formula-like? (string->symbol (caddr found))) about-formulas]
        [(equal? (cadr found) "'")
         (format "a quote stands before a name, and none behind it: '~a" (caddr found))]
        [else (about-prime (caddr found))]))

(define (prime? forms)
  (and (= (length forms) 2)
       (identifier? (car forms))
       (prime-before? (car forms) (cadr forms))))

;; sin x, not sin x y; * 2 x, not * 2
(define (call-data? data)
  (define n (length data))
  (cond [(sign? (car data)) (> n 2)]
        [(memq (car data) functions) (= n 2)]
        [else #t]))

(define (keyword? datum) (and (memq datum '(define lambda λ let let* if cond require begin)) #t))
