#lang racket/base
;; Antiderivatives of forms in |u| or sgn u of a line u, which is zero at x₀.  With sgn u = ±1 on
;; either side the integrand is smooth; where its antiderivative there is F₊ and F₋,
;;
;;     F = ½ (F₊ + F₋) + ½ sgn u (F₊ − F₋)
;;
;; is one, and continuous, if both vanish at x₀.

(require "expression-function.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         "../algebra/expression/operation.rkt"
         "../algebra/expression/substitute.rkt" "../algebra/expression/symbols.rkt"
         "../algebra/simplify/known-sign.rkt" "../algebra/simplify/simplify-expression.rkt"
         "../error/failure.rkt")

(provide integral-by-sides)

;; antiderivative : expression -> expression or #f
(define (integral-by-sides e x A antiderivative)
  (define (simple e) (simplify-expression e A))
  (define (signed n)
    (and (memq (node-head n) (list op:abs op:sgn)) (occurs? x n) (car (node-args n))))
  (for/or ([u (in-list (parts-in e signed))])
    (define slope (simple (expression-derivative u x)))
    (and (not (occurs? x slope))
         (not (eqv? slope 0))
         (let* ([x0 (simple (e:- x (e:/ u slope)))]
                [right (side-integral e u 1 x x0 A antiderivative)]
                [left (side-integral e u -1 x x0 A antiderivative)])
           (and left
                right
                (e:+ (e:/ (e:+ right left) 2)
                     (e:* (e:apply op:sgn u) (e:/ (e:- right left) 2))))))))

;; The antiderivative where sgn u = sign, which is 0 at x0; or #f, as where it has no value there
(define (side-integral e u sign x x0 A antiderivative)
  (define F (antiderivative (simplify-expression (with-sign e u sign) A)))
  (define (at-x0 e) (substitute-expression e (list (cons x x0))))
  (with-handlers ([no-value? (lambda (_) #f)])
    (define real (and F (with-real-logarithms F x A)))
    (and real (e:- real (at-x0 real)))))

;; F with log|u| in place of log u, where u may be negative.  There is no zero of u on the path.
(define (with-real-logarithms F x A)
  (define (real u)
    (if (or (not (occurs? x u)) (eqv? 1 (known-sign u A))) u (e:apply op:abs u)))
  (node-fold F values
             (lambda (n args)
               (define reals (if (headed? n op:log) (map real args) args))
               (if (andmap eq? reals (node-args n)) n (rebuild (node-head n) reals)))))
