#lang racket/base
;; For which exponent is a residual zero?
;;
;; A residual such as c² a Iᵃ⁻ᵇ − 1 is zero at all states only if it does not depend on them: a
;; factor of its derivative by I that holds parameters alone has to vanish, here a − b.  With the
;; exponent so found the others are conditions as ever, c² a = 1.

(require racket/string
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../algebra/expression/symbols.rkt"
         "../calculus/expression-function.rkt"
         "../generic/describe.rkt" "../generic/on-demand.rkt" "../generic/up-down.rkt"
         (only-in "../value/algebra.rkt" meaning-with meaningful?)
         "../value/assumptions.rkt" "../value/simplify.rkt"
         "../verdict/prove-zero.rkt" "../verdict/verdict.rkt")

(require-on-demand ["../algebra/solve/factors.rkt" vanishing-factors]
                   ["../algebra/solve/solve-equations.rkt" solve-equations])

(provide condition-on-exponents)

;; entries : the scalars of a residual; names : symbols of the state; find-meaning : -> the meaning
;; that the question has to keep under the condition
;; -> a text such as "a = 1/2 and (expt c 2) = 2", or #f
(define (condition-on-exponents entries names find-meaning)
  (define open (filter power-of-unknown? (map simplify-strictly entries)))
  (define given (and (pair? open) (meaning-with (filter expression? entries) (find-meaning))))
  (for*/or ([e (in-list open)] [x (in-list names)] #:when (occurs? x e)
            [f (in-list (factors-of-parameters (expression-derivative e x) names))]
            [p (in-list (symbols-in f))]
            [value (in-list (values-of p f))])
    (define equations (sufficient p value entries names given))
    (and equations (string-join (map equation->text equations) " and "))))

;; -> equations that make all entries zero together, p = value first, or #f
(define (sufficient p value entries names given)
  (define equation (list '= p (value->datum value)))
  (define (keeps-meaning? equations) (meaningful? given equations (assumptions-in-force)))
  (define (at-value e) (evaluate-generically e (list (cons p value))))
  (define (rest)
    (prove-zero (apply up (map at-value entries)) #:variables names #:meaning (lambda () given)))
  (define v (and (keeps-meaning? (list equation)) (rest)))
  (cond [(not v) #f]
        [(proved? v) (list equation)]
        [else
         (for/first ([way (in-list (verdict-alternatives v))]
                     #:when (keeps-meaning? (cons equation way)))
           (cons equation way))]))

(define (equation->text e) (format "~a = ~a" (value->text (cadr e)) (value->text (caddr e))))

;; Is there a symbol in an exponent?
(define (power-of-unknown? e)
  (and (node? e)
       (or (and (eq? (node-head e) op:expt) (pair? (symbols-in (cadr (node-args e)))))
           (ormap power-of-unknown? (node-args e)))))

(define (factors-of-parameters e names)
  (for/list ([f (in-list (vanishing-factors (simplify-strictly e) (assumptions-in-force)))]
             #:when (and (pair? (symbols-in f))
                         (not (ormap (lambda (x) (occurs? x f)) names))))
    f))

;; The values of p for which f vanishes, whatever else is in it
(define (values-of p f)
  (define solutions
    (parameterize ([automatic-assumptions #f])
      (or (solve-equations (list f) (list p) (assumptions-in-force)) '())))
  (for*/list ([s (in-list solutions)] #:when (null? (cdr s)) [entry (in-value (assq p (car s)))]
              #:when entry)
    (cdr entry)))
