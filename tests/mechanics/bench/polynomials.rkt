#lang racket/base
;; The cost of polynomial operations:  racket polynomials.rkt
;;
;; CPU microseconds a call, best of several rounds, on seeded random operands.

(require "clock.rkt"
         (only-in mechanics/algebra/polynomial/gcd poly-gcd)
         mechanics/algebra/polynomial/polynomial
         mechanics/algebra/polynomial/fraction)

;; ---------------------------------------------------------------------------
;; Operands

(define (random-monomial R n degree)
  (define v (make-vector (ring-size R) 0))
  (for ([_ (in-range degree)])
    (define i (random n))
    (vector-set! v i (+ 1 (vector-ref v i))))
  (for/fold ([p (poly-constant R (+ 1 (random 20)))]) ([e (in-vector v)] [i (in-naturals)])
    (poly* R p (poly-variable R i e))))

;; About `terms` terms of degree up to `degree` in the first n variables.
(define (random-polynomial R terms degree [n (ring-size R)])
  (poly-sum R (for/list ([_ (in-range terms)])
                (random-monomial R n (random (+ 1 degree))))))

;; ---------------------------------------------------------------------------
;; Timing

(define-syntax-rule (report name calls body)
  (let ([best (for/fold ([best +inf.0]) ([_ (in-range 5)])
                (define-values (result ms)
                  (call/cpu (lambda () (for ([_ (in-range calls)]) body))))
                (min best ms))])
    (printf "~a~a µs\n"
            (pad name 58)
            (microseconds (/ (* 1000 best) calls)))))

(define (pad text width)
  (string-append text (make-string (max 1 (- width (string-length text))) #\space)))

(define (microseconds x)
  (if (< x 10)
      (/ (round (* 100 x)) 100)
      (/ (round (* 10 x)) 10)))

;; ---------------------------------------------------------------------------
;; Tasks

(define (sums-and-products)
  (for ([n '(8 40)])
    (define R (make-ring n 12))
    (define p (random-polynomial R 100 5))
    (define q (random-polynomial R 100 5))
    (define pq (poly* R p q))
    (define (label text) (format "~a, ~a variables" text n))
    (report (label "sum of two of 100 terms") 2000 (poly+ R p q))
    (report (label (format "product of two of 100 terms (~a terms)" (poly-term-count pq)))
            20 (poly* R p q))
    (report (label "that product divided by a factor") 10 (poly-divide R pq q))
    (define s (random-polynomial R 5 3))
    (define t (random-polynomial R 5 3))
    (report (label "product of two of 5 terms") 20000 (poly* R s t))
    (define monomials
      (for/list ([_ (in-range 1000)]) (random-monomial R n (random 6))))
    (report (label "sum of 1000 monomials") 20 (poly-sum R monomials))))

(define (divisors)
  (for ([n '(6 40)])
    (define R (make-ring n 12))
    (define-values (a b g)
      (apply values (for/list ([_ 3]) (random-polynomial R 30 4))))
    (define ag (poly* R a g))
    (define bg (poly* R b g))
    (define (label text) (format "~a, ~a variables" text n))
    (report (label "gcd(a g, b g), factors of 30 terms") 10 (poly-gcd R ag bg))
    (report (label "gcd(a g, g), factors of 30 terms") 10 (poly-gcd R ag g))
    (report (label "coprime test of 30 terms") 500 (poly-gcd R a b))
    (report (label (format "coprime test of ~a terms" (poly-term-count ag)))
            100 (poly-gcd R ag b)))
  (define R (make-ring 4 12))
  (define-values (a b g)
    (apply values (for/list ([_ 3]) (random-polynomial R 4 2))))
  (report "gcd(a g, b g), factors of 4 terms, 4 variables" 200
          (poly-gcd R (poly* R a g) (poly* R b g))))

(define (fractions)
  (define R (make-ring 8 60))
  (define (polynomial) (random-polynomial R 4 2))
  (define (fraction) (fraction/ R (fraction-from-poly R (polynomial))
                                (fraction-from-poly R (polynomial))))
  (define p (polynomial))
  (define q (polynomial))
  (define P (fraction-from-poly R p))
  (define Q (fraction-from-poly R q))
  (report "sum of polynomials of 4 terms" 50000 (poly+ R p q))
  (report "the same as fractions" 50000 (fraction+ R P Q))
  (report "product of polynomials of 4 terms" 50000 (poly* R p q))
  (report "the same as fractions" 50000 (fraction* R P Q))
  (define f (fraction))
  (define g (fraction))
  (report "sum of fractions of 4 terms over 4" 200 (fraction+ R f g))
  (report "product of fractions of 4 terms over 4" 200 (fraction* R f g))
  (define denominators (for/list ([_ 4]) (polynomial)))
  (define fs
    (for*/list ([_ 2] [d (in-list denominators)])
      (fraction/ R (fraction-from-poly R (polynomial)) (fraction-from-poly R d))))
  (report "sum of 8 fractions over 4 denominators" 20 (fraction-sum R fs)))

(module+ main
  (random-seed 20)
  (sums-and-products)
  (divisors)
  (fractions))
