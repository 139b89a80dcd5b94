#lang racket/base
;; Degrees, terms, coefficients along a variable, derivatives, substitution.

(require (only-in mechanics/algebra/polynomial/polynomial-parts poly-derivative poly-substitute)
         mechanics/algebra/polynomial/polynomial
         (only-in mechanics/algebra/polynomial/ring monomial-factors)
         "../../support/checks.rkt" "../../support/random.rkt"
         "../../support/random/polynomial.rkt")

(define R (make-ring 3 12))
(define x (poly-variable R 0))
(define y (poly-variable R 1))
(define z (poly-variable R 2))
(define (number c) (poly-constant R c))
(define (sum . ps) (poly-sum R ps))
(define (product . ps) (for/fold ([r (number 1)]) ([p ps]) (poly* R r p)))

(define example                             ; 3 x²y - 1/2 y³ + 7
  (sum (poly-monomial R 3 '(2 1 0)) (poly-monomial R -1/2 #(0 3 0)) (number 7)))

(test-case "degrees and variables are those of the terms"
  (check-equal? (for/list ([i 3]) (poly-degree R example i)) '(2 3 0))
  (check-equal? (poly-total-degree R example) 3)
  (check-equal? (poly-variables R example) '(0 1))
  (check-equal? (poly-variables R (number 5)) '())
  (check-equal? (poly-total-degree R (number 0)) 0))

(test-case "terms come by decreasing degree, then lexicographically"
  (check-equal? (poly-terms R example)
                '((3 (0 . 2) (1 . 1)) (-1/2 (1 . 3)) (7))))

(test-case "terms put together again give the polynomial, in 50 variables too"
  (for ([n '(3 50)])
    (define R (make-ring n 12))
    (with-seeds 10
      (define p (random-polynomial R #:terms 20 #:degree 12))
      (define terms
        (for/list ([t (poly-terms R p)])
          (for/fold ([term (poly-constant R (poly-term-coefficient t))])
                    ([f (poly-term-powers t)])
            (poly* R term (poly-variable R (power-base f) (power-exponent f))))))
      (check-equal? (poly-sum R terms) p))))

(test-case "coefficients along a variable come by decreasing degree and rebuild the polynomial"
  (check-equal? (poly-coefficients R example 0)
                (list (cons 2 (poly-scale R 3 y))
                      (cons 0 (sum (poly-scale R -1/2 (poly-expt R y 3)) (number 7)))))
  (with-seeds 20
    (define p (random-polynomial R #:terms 15 #:degree 8))
    (for ([i 3])
      (define cs (poly-coefficients R p i))
      (check-true (or (null? cs) (apply > (map car cs))))
      (check-false (for/or ([c cs]) (memv i (poly-variables R (cdr c)))))
      (check-equal? (poly-from-coefficients R i cs) p))))

(test-case "the derivative is a derivation that knows its variable"
  (check-equal? (poly-derivative R example 1)
                (sum (poly-scale R 3 (product x x)) (poly-scale R -3/2 (product y y))))
  (with-seeds 20
    (define p (random-polynomial R))
    (define q (random-polynomial R))
    (for ([i 3])
      (define (D p) (poly-derivative R p i))
      (check-equal? (D (poly+ R p q)) (poly+ R (D p) (D q)))
      (check-equal? (D (poly* R p q)) (sum (poly* R (D p) q) (poly* R p (D q)))))
    (check-equal? (poly-derivative R (poly-derivative R p 0) 1)
                  (poly-derivative R (poly-derivative R p 1) 0))))

(test-case "substitution keeps sums and products and replaces the variable"
  (define S (make-ring 3 60))
  (with-seeds 20
    (define p (random-polynomial S))
    (define q (random-polynomial S))
    (define r (random-polynomial S))
    (define (put p) (poly-substitute S p 1 r))
    (check-equal? (put (poly-variable S 1)) r)
    (check-equal? (put (poly-variable S 0)) (poly-variable S 0))
    (check-equal? (put (poly+ S p q)) (poly+ S (put p) (put q)))
    (check-equal? (put (poly* S p q)) (poly* S (put p) (put q)))))

(test-case "content is the positive rational that leaves coprime integers"
  (check-equal? (poly-content (sum (poly-scale R 4/3 x) (poly-scale R -2/5 y))) 2/15)
  (check-equal? (poly-content (number 0)) 0)
  (check-equal? (poly-content (number -6)) 6)
  (define-values (c p) (poly-primitive R (sum (poly-scale R -4/3 x) (poly-scale R 2/5 y))))
  (check-equal? c -2/15)
  (check-equal? p (sum (poly-scale R 10 x) (poly-scale R -3 y)))
  (with-seeds 30
    (define p (random-polynomial R))
    (define-values (c primitive) (poly-primitive R p))
    (check-equal? (poly-scale R c primitive) p)
    (unless (poly-zero? p)
      (check-true (positive? (poly-leading-coefficient primitive)))
      (check-equal? (poly-content primitive) 1)
      (check-equal? (abs c) (poly-content p)))))

(test-case "the monomial content is the greatest monomial that divides all terms"
  (define (content p) (monomial-factors R (common-monomial R p)))
  (check-equal? (content (product x x y (sum (product x y) z))) '((0 . 2) (1 . 1)))
  (check-equal? (content (sum x (number 1))) '())
  (check-equal? (content (product x z)) '((0 . 1) (2 . 1))))
