#lang racket/base
;; Bounds on the growth of fractions, counted in terms, never in time.
;;
;; Every step of arithmetic spends *fuel*, as much as terms are multiplied or
;; added; where divisors are looked for, several times as much.  A step that
;; would take more than a bound is an obstacle: the expression is left
;; unexpanded there.  The bounds are far above what mechanics meets, and low
;; enough for a session to go on: a full tank lasts some seconds.  When it is
;; empty only small steps are made.

(require "walk.rkt" "polynomial/polynomial.rkt" "polynomial/fraction.rkt")

(provide make-fuel call-nested check-multiplication check-expansion check-addition spend-on-terms!)

;; nested? : is this the argument of a kernel?
(struct fuel ([left #:mutable] [nested? #:mutable]) #:authentic)

(define (make-fuel) (fuel 10000000 #f))

;; Arguments of kernels are held to closer bounds.
(define (call-nested tank thunk)
  (define outer (fuel-nested? tank))
  (set-fuel-nested?! tank #t)
  (begin0 (thunk)
          (set-fuel-nested?! tank outer)))

;; What a step may cost and how many terms may be added up; in an argument; and
;; when the tank is empty.
(struct limits (step sum) #:authentic)
(define outer-limits (limits 1000000 8000))
(define inner-limits (limits 20000 100))
(define small-limits (limits 1000 30))

(define (current-limits tank)
  (cond [(<= (fuel-left tank) 0) small-limits]
        [(fuel-nested? tank) inner-limits]
        [else outer-limits]))

;; How much dearer fractions are than polynomials, presentation than arithmetic.
(define fraction-factor 20)
(define presentation-factor 1000)

(define (spend! tank cost)
  (when (> cost (limits-step (current-limits tank))) (raise-obstacle))
  (set-fuel-left! tank (- (fuel-left tank) cost)))

(define (spend-on-terms! tank n)
  (set-fuel-left! tank (- (fuel-left tank) (* presentation-factor n))))

(define (check-multiplication tank f g)
  (spend! tank (* (cost-factor f g) (numerator-size f) (numerator-size g))))

(define (cost-factor f g)
  (if (and (fraction-polynomial? f) (fraction-polynomial? g)) 1 fraction-factor))

;; (a₁ + ... + aₙ)^k has (n + k - 1 choose k) terms.
(define (check-expansion tank f k)
  (define n (numerator-size f))
  (define factor (cost-factor f f))
  (define bound (limits-step (current-limits tank)))
  (let loop ([i 1] [terms 1])
    (cond [(> (* factor terms n) bound) (raise-obstacle)]
          [(and (< i k) (> n 1)) (loop (+ i 1) (/ (* terms (+ n i -1)) i))]
          [else (spend! tank (* factor terms n))])))

;; Each numerator is multiplied by the denominators of the others.
(define (check-addition tank fs)
  (define terms (for/sum ([f (in-list fs)]) (numerator-size f)))
  (when (> terms (limits-sum (current-limits tank))) (raise-obstacle))
  (define denominators
    (for/fold ([size 0]) ([f (in-list fs)]) (max size (denominator-size f))))
  (spend! tank (if (eqv? denominators 1) terms (* fraction-factor denominators terms))))

(define (numerator-size f) (poly-term-count (fraction-numerator f)))

(define (denominator-size f)
  (for/fold ([size 1]) ([h (in-list (fraction-denominator-factors f))])
    (* size (expt (poly-term-count (car h)) (min 20 (cdr h))))))
