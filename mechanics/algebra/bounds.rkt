#lang racket/base
;; Bounds on the growth of fractions, counted in terms, never in time.
;;
;; An operation whose result could pass them is an obstacle: the expression is
;; left unexpanded there.  They are far above what mechanics meets and low
;; enough for a session to go on: the largest step allowed takes some tenths of
;; a second.

(require "walk.rkt" "polynomial/polynomial.rkt" "polynomial/fraction.rkt")

(provide check-multiplication check-expansion check-addition)

;; Products of terms in one step.
(define product-limit 1000000)
;; The same where denominators are involved and divisors are looked for.
(define fraction-limit 100000)

(define (limit-for fs)
  (if (andmap fraction-polynomial? fs) product-limit fraction-limit))

(define (check work fs)
  (when (> work (limit-for fs)) (raise-obstacle)))

(define (check-multiplication f g)
  (check (* (numerator-size f) (numerator-size g)) (list f g)))

;; (a₁ + ... + aₙ)^k has (n + k - 1 choose k) terms.
(define (check-expansion f k)
  (define n (numerator-size f))
  (define bound (limit-for (list f)))
  (let loop ([i 1] [terms 1])
    (cond [(> (* terms n) bound) (raise-obstacle)]
          [(and (< i k) (> n 1)) (loop (+ i 1) (/ (* terms (+ n i -1)) i))])))

;; Each numerator is multiplied by the denominators of the others.
(define (check-addition fs)
  (unless (andmap fraction-polynomial? fs)
    (define denominators (for/fold ([size 1]) ([f (in-list fs)]) (max size (denominator-size f))))
    (check (for/sum ([f (in-list fs)]) (* denominators (numerator-size f))) fs)))

(define (numerator-size f) (poly-term-count (fraction-numerator f)))

(define (denominator-size f)
  (for/fold ([size 1]) ([h (in-list (fraction-denominator-factors f))])
    (* size (expt (poly-term-count (car h)) (min 20 (cdr h))))))
