#lang racket/base
;; The momentum that makes a function of it take a value: f(p) = E with f of degree 1 or 2,
;;
;;     a p² + b p + c = E,     p = −b/2a ± √((b/2a)² + (E − c)/a).

(require "../calculus/derivative.rkt"
         "../generic/arithmetic.rkt" "../generic/elementary.rkt"
         "../value/simplify.rkt")

(provide degree-in momentum-by-energy middle-and-radicand)

;; f : at symbols, p a symbol of its own -> 0, 1 or 2; #f if it is of another degree or none
(define (degree-in f p)
  (define (slope p) (derivative-at f p))
  (define (bend p) (derivative-at slope p))
  (define (none? derivative) (eqv? 0 (simplify-strictly (derivative p))))
  (cond [(not (none? (lambda (p) (derivative-at bend p)))) #f]
        [(not (none? bend)) 2]
        [(not (none? slope)) 1]
        [else 0]))

;; sign : 1 or −1, of the root
(define (momentum-by-energy f degree E sign)
  (cond [(= degree 1) (g:/ (g:- E (f 0)) (derivative-at f 0))]
        [else
         (define-values (middle radicand) (middle-and-radicand f E))
         (define root (g:sqrt radicand))
         (if (= sign 1) (g:+ middle root) (g:- middle root))]))

;; −b/2a and (b/2a)² + (E − c)/a, of degree 2
(define (middle-and-radicand f E)
  (define a (g:* 1/2 (derivative-at (lambda (p) (derivative-at f p)) 0)))
  (define middle (g:/ (derivative-at f 0) (g:* -2 a)))
  (values middle (g:+ (g:square middle) (g:/ (g:- E (f 0)) a))))
