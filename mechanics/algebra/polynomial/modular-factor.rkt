#lang racket/base
;; Factors of univariate polynomials modulo a prime, by Cantor and Zassenhaus.
;;
;; The elements of the field with P^d elements are the roots of x^(P^d) - x; so
;; gcd(f, x^(P^d) - x) is the product of the factors of f of degree d, once those
;; of lower degrees are taken out.  Modulo each of those factors a power
;; a^((P^d - 1)/2) is 1 or -1, by chance and independently: the gcd of f with it
;; less 1 splits them.  Chance is a fixed sequence, so results are reproducible.

(require "dense.rkt")

(provide modular-factors)

;; The monic irreducible factors of f, monic and square-free.
(define (modular-factors f P)
  (let loop ([f f] [power #(0 1)] [d 1])
    (cond [(eqv? (dense-degree f) 0) '()]
          [(> (* 2 d) (dense-degree f)) (list f)]
          [else
           (define next (dense-expt-modulo power P f P))
           (define g (dense-gcd f (dense- next #(0 1) P) P))
           (cond [(eqv? (dense-degree g) 0) (loop f next (+ d 1))]
                 [else
                  (define-values (rest zero) (dense-divide f g P))
                  (append (equal-degree-factors g d P 1)
                          (loop rest next (+ d 1)))])])))

;; The factors of g, all of degree d.
(define (equal-degree-factors g d P seed)
  (cond [(eqv? (dense-degree g) d) (list g)]
        [else
         (define a (sample (dense-degree g) seed P))
         (define power (dense-expt-modulo a (quotient (- (expt P d) 1) 2) g P))
         (define h (dense-gcd g (dense- power #(1) P) P))
         (cond [(< 0 (dense-degree h) (dense-degree g))
                (define-values (other zero) (dense-divide g h P))
                (append (equal-degree-factors h d P (+ seed 1))
                        (equal-degree-factors other d P (+ seed 1)))]
               [else (equal-degree-factors g d P (+ seed 1))])]))

;; A polynomial of degree below n that nothing distinguishes.
(define (sample n seed P)
  (define (mix x) (modulo (+ (* x x) (* 362436069 x) 69069) P))
  (dense (for/vector #:length n ([i (in-range n)])
           (mix (mix (mix (+ (* 40503017 seed) (* 7919 i) 1)))))
         P))
