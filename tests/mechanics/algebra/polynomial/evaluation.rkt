#lang racket/base
;; Evaluation is a homomorphism, over the rationals and over prime fields.

(require mechanics/algebra/polynomial/polynomial
         "../../support/checks.rkt" "../../support/evaluate-polynomial.rkt"
         "../../support/random.rkt"
         "../../support/random/polynomial.rkt")

;; Which of sums, products and 1 the evaluation fails to keep, at some of the
;; points, for some of the pairs of polynomials.
(define (homomorphism-failures R evaluate plus times points samples)
  (define (fails holds?)
    (for*/or ([point points] [s samples]) (not (holds? point (car s) (cadr s)))))
  (append
   (if (fails (lambda (at p q)
                (equal? (evaluate (poly+ R p q) at) (plus (evaluate p at) (evaluate q at)))))
       '(sum) '())
   (if (fails (lambda (at p q)
                (equal? (evaluate (poly* R p q) at) (times (evaluate p at) (evaluate q at)))))
       '(product) '())
   (if (fails (lambda (at p q) (equal? (evaluate (poly-constant R 1) at) 1)))
       '(one) '())))

(define (samples R n) (for/list ([_ (in-range n)]) (random-polynomials R 2)))

(for ([n '(1 4 50)])
  (test-case (format "evaluation at rational points keeps sums and products, ~a variables" n)
    (define R (make-ring n 12))
    (with-seeds 5
      (define points (for/list ([_ 3]) (random-point n)))
      (check-equal? (homomorphism-failures R (lambda (p at) (poly-evaluate R p at))
                                           + * points (samples R 10))
                    '()))))

(for ([prime '(101 1073741789)])
  (test-case (format "evaluation modulo ~a keeps sums and products" prime)
    (define R (make-ring 4 12))
    (with-seeds 5
      (define points
        (for/list ([_ 3]) (for/vector ([_ 4]) (random prime))))
      (check-equal? (homomorphism-failures
                     R (lambda (p at) (poly-evaluate-mod R p at prime))
                     (lambda (a b) (modulo (+ a b) prime))
                     (lambda (a b) (modulo (* a b) prime))
                     points (samples R 10))
                    '()))))

(test-case "every one of these laws fails for a wrong evaluation"
  (define R (make-ring 4 12))
  (with-seeds 1
    (define points (for/list ([_ 3]) (random-point 4)))
    (define (failures evaluate)
      (homomorphism-failures R evaluate + * points (samples R 10)))
    (check-equal? (failures (lambda (p at) (+ 1 (poly-evaluate R p at))))
                  '(sum product one))
    (check-equal? (failures (lambda (p at) (* 2 (poly-evaluate R p at))))
                  '(product one))))

(test-case "evaluation modulo a prime is the residue of the rational value"
  (define R (make-ring 3 12))
  (define prime 1073741789)
  (with-seeds 20
    (define p (random-polynomial R))
    (define point (for/vector ([_ 3]) (random 1000)))
    (define value (poly-evaluate R p point))
    (check-equal? (modulo (* (poly-evaluate-mod R p point prime) (denominator value)) prime)
                  (modulo (numerator value) prime))))

(test-case "flonums may be substituted"
  (define R (make-ring 2 5))
  (define p (poly+ R (poly-monomial R 1/2 '(2 1)) (poly-constant R 3)))
  (check-= (poly-evaluate R p (vector 2.0 0.25)) 3.5 1e-15))
