#lang racket/base
;; Antiderivatives of single functions, and of quotients and exponentials that are no sums of waves.
;;
;;     ∫ dx/(a + b cos x) = (x − 2 atan(b sin x/(a + s + b cos x)))/s,   s = √(a² − b²),   a > |b|,
;;
;; which is continuous, as the usual form by tan x/2 is not, and
;;
;;     ∫ e^(−s²x²) dx = √π/2s erf(sx).
;;
;; (Gradshteyn and Ryzhik, 2.5, 2.7; DLMF 4.26, 4.40, 7.1.)

(require "expression-function.rkt" (only-in "quadratic-antiderivative.rkt" root-of)
         "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         "../algebra/expression/operation.rkt" "../algebra/expression/pi.rkt"
         "../algebra/expression/substitute.rkt" "../algebra/expression/symbols.rkt"
         "../algebra/simplify/known-sign.rkt" "../algebra/simplify/simplify-expression.rkt")

(provide integral-of-known linear-in)

;; An expression whose derivative by x is e, or #f
(define (integral-of-known e x A)
  (or (integral-from-table e x A)
      (integral-over-cosine e x A)
      (integral-of-Gaussian e x A)))

(define (function op) (lambda (u) (e:apply op u)))
(define-values (sin cos tan) (values (function op:sin) (function op:cos) (function op:tan)))
(define-values (sinh cosh tanh) (values (function op:sinh) (function op:cosh) (function op:tanh)))
(define-values (asin atan) (values (function op:asin) (function op:atan)))
(define-values (log sqrt) (values (function op:log) (function op:sqrt)))
(define (square u) (e:expt u 2))

;; The function of which it is the integral, its power, and the integral
(define table
  (list (list op:log 1 (lambda (x) (e:- (e:* x (log x)) x)))
        (list op:cosh 1 sinh)
        (list op:sinh 1 cosh)
        (list op:tanh 1 (lambda (x) (log (cosh x))))
        (list op:cosh -2 tanh)
        (list op:cos -2 tan)
        (list op:sin -2 (lambda (x) (e:* -1 (e:/ (cos x) (sin x)))))
        (list op:cos -1 (lambda (x) (e:apply op:atanh (sin x))))
        (list op:sin -1 (lambda (x) (e:* -1 (e:apply op:atanh (cos x)))))
        (list op:atan 1 (lambda (x) (e:- (e:* x (atan x)) (e:/ (log (e:+ 1 (square x))) 2))))
        (list op:asin 1 (lambda (x) (e:+ (e:* x (asin x)) (sqrt (e:- 1 (square x))))))))

(define (integral-from-table e x A)
  (for/or ([entry (in-list table)])
    (define-values (head power integral) (apply values entry))
    (and (some-node? (lambda (n) (headed? n head)) e)
         (let ([c (simplify-expression (e:/ e (e:expt (e:apply head x) power)) A)])
           (and (not (occurs? x c)) (e:* c (integral x)))))))

;; c/(a + b cos x)
(define (integral-over-cosine e x A)
  (for/or ([D (in-list (parts-in e divisor-of))])
    (define-values (a b) (linear-in (cos x) D x A))
    (define c (and a (simplify-expression (e:* e D) A)))
    (define Δ (and c (not (eqv? b 0)) (not (occurs? x c)) (e:- (square a) (square b))))
    (and Δ
         (eqv? 1 (known-sign Δ A))
         (eqv? 1 (known-sign a A))
         (let* ([s (simplify-expression (make-node op:sqrt (list Δ)) A)]
                [tangent (e:/ (e:* b (sin x)) (e:+ (e:+ a s) (e:* b (cos x))))])
           (e:* (e:/ c s) (e:- x (e:* 2 (atan tangent))))))))

;; e = a + b f with a and b that do not depend on x -> a b, or #f #f
(define (linear-in f e x A)
  (define mark (string->uninterned-symbol "f"))
  (define marked (substitute-expression e (list (cons f mark))))
  (define b (simplify-expression (expression-derivative marked mark) A))
  (define a (simplify-expression (substitute-expression marked (list (cons mark 0))) A))
  (if (or (occurs? x a) (occurs? x b) (occurs? mark b)) (values #f #f) (values a b)))

;; c e^(−kx²)
(define (integral-of-Gaussian e x A)
  (for/or ([n (in-list (nodes-in e))] #:when (headed? n op:exp))
    (define k (simplify-expression (e:/ (car (node-args n)) (e:* -1 (square x))) A))
    (define c (simplify-expression (e:/ e n) A))
    (define s (and (not (occurs? x k)) (not (occurs? x c)) (root-of k A)))
    (and s
         (not (eqv? s 0))
         (e:* c (e:* (e:/ (sqrt exact-pi) (e:* 2 s)) (e:apply op:erf (e:* s x)))))))
