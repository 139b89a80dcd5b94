#lang racket/base
;; Factors over the rationals: products of random factors come apart, what is
;; irreducible does not.

(require mechanics/algebra/polynomial/polynomial
         mechanics/algebra/polynomial/factor
         mechanics/algebra/polynomial/integer-factor
         mechanics/algebra/polynomial/dense
         mechanics/algebra/polynomial/modular-factor
         "../../support/checks.rkt" "../../support/random.rkt"
         "../../support/random/polynomial.rkt")

(define R (make-ring 4 30))

;; A polynomial in x₀ from its coefficients, the constant one first.
(define (univariate . cs)
  (poly-sum R (for/list ([c (in-list cs)] [e (in-naturals)])
                (poly-scale R c (poly-variable R 0 e)))))

(define (poly-product ps)
  (for/fold ([product (poly-constant R 1)]) ([p (in-list ps)]) (poly* R product p)))

(define (same-up-to-number? p q)
  (define-values (c p*) (poly-primitive R p))
  (define-values (d q*) (poly-primitive R q))
  (poly=? p* q*))

(define (count-factors p) (for/sum ([f (in-list (poly-factor R p))]) (cdr f)))

(define (check-factors p at-least)
  (define factors (poly-factor R p))
  (check-true (same-up-to-number?
               p
               (poly-product (for/list ([f (in-list factors)]) (poly-expt R (car f) (cdr f))))))
  (check-true (>= (for/sum ([f (in-list factors)]) (cdr f)) at-least))
  (for ([f (in-list factors)])
    (check-equal? (poly-factor R (car f)) (list (cons (car f) 1)))))

(define (small-coefficient) (- (random 9) 4))

(define (random-factors count terms)
  (filter (lambda (p) (not (poly-constant? p)))
          (for/list ([_ (in-range count)])
            (random-polynomial R #:terms terms #:degree 3 #:coefficient small-coefficient))))

(test-case "products of random polynomials come apart, and their factors no further"
  (with-seeds 40
    (define factors (random-factors (+ 1 (random 3)) 5))
    (unless (null? factors)
      (check-factors (poly-product factors) (length factors)))))

(test-case "the same with coefficients of any size"
  (with-seeds 15
    (define factors
      (filter (lambda (p) (not (poly-constant? p)))
              (for/list ([_ 2]) (random-polynomial R #:terms 4 #:degree 2))))
    (unless (null? factors)
      (check-factors (poly-product factors) (length factors)))))

(test-case "multiplicities are kept"
  (define p (univariate 1 0 1))
  (define q (poly+ R (poly-variable R 0) (poly-variable R 1 2)))
  (check-equal? (sort (map cdr (poly-factor R (poly* R (poly-expt R p 3) (poly-expt R q 2)))) <)
                '(2 3)))

(test-case "polynomials without factors stay whole"
  (for ([p (list (univariate 1 0 1)
                 (univariate 1 0 -10 0 1)       ; of √2 + √3; reducible modulo every prime
                 (univariate 576 0 -960 0 352 0 -40 0 1)   ; of √2 + √3 + √5
                 (univariate 1 1 1 1 1)
                 (poly+ R (poly-variable R 0 2) (poly-variable R 1 2))
                 (poly- R (poly-variable R 0 2) (poly-variable R 1 3))
                 (poly-sum R (list (poly-variable R 0 3) (poly-variable R 1 3)
                                   (poly-variable R 2 2) (poly-constant R 1))))])
    (check-equal? (count-factors p) 1)))

(test-case "binomials have as many factors as theory says"
  (define (binomial n) (poly- R (poly-variable R 0 n) (poly-variable R 1 n)))
  (for ([n '(2 3 4 6 8 12)] [divisors '(2 2 3 4 4 6)])
    (check-equal? (count-factors (binomial n)) divisors)))

(test-case "leading coefficients need not be numbers"
  (define-values (x y a b) (apply values (for/list ([i 4]) (poly-variable R i))))
  (define (sum . ps) (poly-sum R ps))
  (define (times . ps) (poly-product ps))
  (define p (sum (times a x x) (times b y y) (poly-constant R 1)))
  (define q (sum (times b x x y) (times a a y x) (poly-constant R -3) (times y y)))
  (check-factors (times p q) 2)
  (check-equal? (length (poly-factor R (times p q))) 2))

(test-case "integer polynomials, many factors at once"
  (check-equal? (length (integer-factors (list->vector (append '(-1) (for/list ([_ 11]) 0) '(1)))))
                6)
  (define wilkinson
    (for/fold ([p #(1)]) ([k (in-range 1 11)])
      (for/vector #:length (+ 1 (vector-length p)) ([i (in-range (+ 1 (vector-length p)))])
        (- (if (> i 0) (vector-ref p (- i 1)) 0)
           (if (< i (vector-length p)) (* k (vector-ref p i)) 0)))))
  (check-equal? (sort (integer-factors wilkinson) > #:key (lambda (f) (vector-ref f 0)))
                (for/list ([k (in-range 1 11)]) (vector (- k) 1))))

(test-case "modular factors multiply to the polynomial"
  (define P (prime-above 1000))
  (with-seeds 10
    (define f (dense-monic (dense (for/vector ([_ 9]) (+ 1 (random 1000))) P) P))
    (when (dense-one? (dense-gcd f (dense-derivative f P) P))
      (check-equal? (for/fold ([p #(1)]) ([g (in-list (modular-factors f P))]) (dense* p g P)) f))))

(test-case "inverses and Bezout coefficients modulo large primes"
  (define P (prime-above (expt 10 20)))
  (define p #(3 0 5 1))
  (define q #(7 2 1))
  (define-values (u v) (dense-bezout p q P))
  (check-equal? (dense- (dense* u p P) (dense- #(1) (dense* v q P) P) P) #())
  (check-false (prime-above (expt 2 5000))))
