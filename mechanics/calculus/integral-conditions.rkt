#lang racket/base
;; Under what conditions F(high) − F(low) is the integral of e, of which F is an antiderivative.
;;
;; F must not be interrupted between the ends: an argument u of a logarithm or a denominator in F
;; is not 0 there, and one of a root not negative.  If u is a line in x, that is seen at the ends:
;; u(low) u(high) > 0.  What divides F and not e is not 0 either, as k in the integral of e^(kx),
;; n + 1 in that of xⁿ, a − b in that of sin ax sin bx.  And F' = e may hold for some signs alone.
;;
;; A condition is a relation as `assume` takes it, with the variable written x; that u is not 0
;; is (> (abs u) 0).

(require racket/list
         "expression-function.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../algebra/expression/substitute.rkt" "../algebra/expression/symbols.rkt"
         "../algebra/solve/factors.rkt"
         "../algebra/simplify/known-sign.rkt" "../algebra/simplify/simplify-expression.rkt")

(provide integral-conditions-of never-holds?)

;; -> a list of datums, some of which may never hold; declared ones are among them
(define (integral-conditions-of e F x low high A)
  (define divisors (factors-of (denominators F) A))
  (define ends (list low high))
  (define (moves? u) (occurs? x u))
  (remove-duplicates
   (append
    (append-map (lambda (u) (apart-from-0 u x ends A))
                (append (filter moves? divisors) (filter moves? (arguments F op:log))))
    (append-map (lambda (u) (not-negative u x ends A)) (filter moves? (arguments F op:sqrt)))
    (append-map (lambda (power) (finite-power power x ends A)) (symbolic-powers F x))
    (append-map (lambda (u) (not-zero u A))
                (remove* (factors-of (denominators e) A) (filter-not moves? divisors)))
    (grounds-of F e x A))))

(define impossible '(> -1 0))

;; Is it (> u 0) of a number u that is not?
(define (never-holds? datum)
  (and (eq? (car datum) '>) (real? (cadr datum)) (<= (cadr datum) 0)))

;; ---------------------------------------------------------------------------
;; Parts of an expression

(define (denominators e)
  (parts-of-expression e (lambda (n)
             (define args (node-args n))
             (cond [(eq? (node-head n) op:/) (cadr args)]
                   [(and (eq? (node-head n) op:expt) (real? (cadr args)) (negative? (cadr args)))
                    (car args)]
                   [else #f]))))

(define (arguments e op)
  (parts-of-expression e (lambda (n) (and (eq? (node-head n) op) (car (node-args n))))))

;; (base . exponent) of powers with an exponent that is no number
(define (symbolic-powers e x)
  (parts-of-expression e (lambda (n)
             (define args (node-args n))
             (and (eq? (node-head n) op:expt)
                  (occurs? x (car args))
                  (not (real? (cadr args)))
                  (cons (car args) (cadr args))))))

;; Bases of the factors of the expressions, but numbers
(define (factors-of es A)
  (remove-duplicates
   (for*/list ([e (in-list es)] [f (in-list (expression-factors e A))]
               #:unless (real? (car f)))
     (car f))))

;; ---------------------------------------------------------------------------
;; Conditions

(define (relation u A) (list '> (expression->datum (simplify-expression u A)) 0))

(define (not-zero u A)
  (if (memv (known-sign u A) '(1 -1))
      '()
      (list (relation (e:apply op:abs u) A))))

(define (line? u x A)
  (eqv? 0 (simplify-expression (expression-derivative (expression-derivative u x) x) A)))

(define (at u x end) (substitute-expression u (list (cons x end))))

(define (apart-from-0 u x ends A)
  (cond [(memv (known-sign u A) '(1 -1)) '()]
        [(line? u x A)
         (define product (e:* (at u x (car ends)) (at u x (cadr ends))))
         (case (known-sign product A)
           [(1) '()]
           [(-1) (list impossible)]
           [else (list (relation product A))])]
        [else (list (relation (e:apply op:abs (at u x 'x)) A))]))

(define (not-negative u x ends A)
  (define (condition v)
    (if (memv (known-sign v A) '(0 1))
        '()
        (list (list '>= (expression->datum (simplify-expression v A)) 0))))
  (cond [(eqv? (known-sign u A) 1) '()]
        [(line? u x A) (append-map (lambda (end) (condition (at u x end))) ends)]
        [else (condition (at u x 'x))]))

;; uⁿ at the ends: of u = 0 there n is positive; else u is positive
(define (finite-power power x ends A)
  (define-values (u n) (values (car power) (cdr power)))
  (append-map (lambda (end)
                (define v (simplify-expression (at u x end) A))
                (define must (if (eqv? v 0) n v))
                (if (eqv? 1 (known-sign must A)) '() (list (relation must A))))
              ends))

;; What F' = e rests on
(define (grounds-of F e x A)
  (define-values (_ grounds)
    (simplify-expression/assumptions (e:- (expression-derivative F x) e) A))
  (for/list ([g (in-list grounds)] #:unless (eq? (car g) 'left-unexpanded))
    (renamed g x)))

(define (renamed datum x)
  (cond [(eq? datum x) 'x]
        [(pair? datum) (cons (renamed (car datum) x) (renamed (cdr datum) x))]
        [else datum]))
