#lang racket/base
;; Sums and products of polynomials are a ring, in few variables and in many.

(require (only-in mechanics/algebra/polynomial/polynomial-parts poly-hash poly-substitute)
         mechanics/algebra/polynomial/polynomial
         "../../support/checks.rkt" "../../support/random.rkt"
         "../../support/laws/law.rkt" "../../support/laws/ring.rkt"
         "../../support/random/polynomial.rkt")

;; The ring of polynomials, with some operations made wrong.
(define (polynomial-ring R #:add [add (lambda (p q) (poly+ R p q))]
                         #:subtract [subtract (lambda (p q) (poly- R p q))]
                         #:negate [negate (lambda (p) (poly-negate R p))]
                         #:multiply [multiply (lambda (p q) (poly* R p q))])
  (ring (poly-constant R 0) (poly-constant R 1) add subtract negate multiply
        #f (lambda (p) (poly-expt R p 2)) (lambda (p n) (poly-expt R p n))))

(define laws (append ring-laws commutativity-laws power-laws))

;; ---------------------------------------------------------------------------
;; Laws

(for ([n '(0 1 2 8 50)])
  (define R (make-ring n 20))
  (check-laws (format "polynomials in ~a variables" n) laws (polynomial-ring R)
              (lambda () (random-polynomial R)) poly=? #:seed 1 #:rounds 100))

(let ()
  (define R (make-ring 3 20))
  (define one (poly-constant R 1))
  (define (double p) (poly-scale R 2 p))
  (define-syntax-rule (breaks name option wrong)
    (check-broken name laws (polynomial-ring R option wrong)
                  (lambda () (random-polynomial R)) poly=? #:seed 1))
  (breaks "addition commutes" #:add (lambda (p q) (poly+ R p (double q))))
  (breaks "addition associates" #:add (lambda (p q) (poly+ R p (double q))))
  (breaks "zero is neutral on the right" #:add (lambda (p q) (poly+ R (poly+ R p q) one)))
  (breaks "a negative cancels" #:negate values)
  (breaks "subtraction undoes addition" #:subtract (lambda (p q) (poly- R q p)))
  (breaks "multiplication commutes" #:multiply (lambda (p q) (poly* R p (poly+ R q one))))
  (breaks "multiplication associates" #:multiply (lambda (p q) (poly* R p (poly+ R q one))))
  (breaks "one is neutral on the right" #:multiply (lambda (p q) (double (poly* R p q))))
  (breaks "zero times anything plus it is it"
          #:multiply (lambda (p q) (poly+ R (poly* R p q) one)))
  (breaks "multiplication distributes on the left"
          #:multiply (lambda (p q) (poly* R p (poly* R q q)))))

(test-case "scaling is multiplication by a constant"
  (define R (make-ring 4 10))
  (with-seeds 20
    (define c (random-coefficient))
    (define p (random-polynomial R))
    (check-equal? (poly-scale R c p) (poly* R (poly-constant R c) p))))

(test-case "a power is a repeated product"
  (define R (make-ring 3 20))
  (with-seeds 20
    (define p (random-polynomial R))
    (check-equal? (poly-expt R p 0) (poly-constant R 1))
    (for/fold ([power (poly-constant R 1)]) ([k (in-range 5)])
      (check-equal? (poly-expt R p k) power)
      (poly* R power p))))

(test-case "the sum of a list is its sum in any order"
  (define R (make-ring 5 10))
  (with-seeds 10
    (define ps (for/list ([_ (in-range 30)]) (random-polynomial R)))
    (define expected (for/fold ([s (poly-constant R 0)]) ([p ps]) (poly+ R s p)))
    (check-equal? (poly-sum R ps) expected)
    (check-equal? (poly-sum R (reverse ps)) expected))
  (check-true (poly-zero? (poly-sum R '()))))

;; ---------------------------------------------------------------------------
;; Form

(test-case "equal polynomials are equal? and hash alike, however they were made"
  (define R (make-ring 40 10))
  (with-seeds 10
    (define p (random-polynomial R))
    (define q (random-polynomial R))
    (define a (poly* R (poly+ R p q) (poly- R p q)))
    (define b (poly- R (poly* R p p) (poly* R q q)))
    (check-true (poly=? a b))
    (check-equal? a b)
    (check-equal? (poly-hash a) (poly-hash b)))
  (check-false (poly=? (poly-variable R 0) (poly-variable R 1)))
  (check-false (poly=? (poly-variable R 0) (poly-constant R 0))))

(test-case "constants are recognised and have a value"
  (define R (make-ring 2 5))
  (check-true (poly-constant? (poly-constant R 3/4)))
  (check-equal? (poly-constant-value (poly-constant R 3/4)) 3/4)
  (check-true (poly-constant? (poly-constant R 0)))
  (check-equal? (poly-constant-value (poly-constant R 0)) 0)
  (check-false (poly-constant? (poly-variable R 1)))
  (check-true (poly-zero? (poly-monomial R 0 '(1 1))))
  (check-equal? (poly-variable R 1 0) (poly-constant R 1))
  (check-equal? (poly-term-count (poly+ R (poly-variable R 0) (poly-constant R 1))) 2))

;; ---------------------------------------------------------------------------
;; Degree overflow

(define-syntax-rule (check-overflow degree bound body)
  (check-exn (lambda (e)
               (and (exn:algebra:degree-overflow? e)
                    (= degree (exn:algebra:degree-overflow-degree e))
                    (= bound (exn:algebra:degree-overflow-bound e))))
             (lambda () body)))

(for ([n '(3 50)])
  (test-case (format "a degree beyond the ring of ~a variables raises, never wraps" n)
    (define R (make-ring n 7))
    (define x (poly-variable R 0))
    (define y (poly-variable R (- n 1)))
    (define xy (poly+ R x y))
    (check-equal? (poly-total-degree R (poly-expt R xy 7)) 7)
    (check-overflow 8 7 (poly-expt R xy 8))
    (check-overflow 8 7 (poly* R (poly-expt R xy 4) (poly-expt R xy 4)))
    (check-overflow 8 7 (poly-variable R 1 8))
    (check-overflow 9 7 (poly-expt R (poly-variable R 2 3) 3))
    (check-overflow 8 7 (poly-monomial R 1 (for/list ([i (in-range n)]) (if (< i 2) 4 0))))
    (check-overflow 8 7 (poly-substitute R (poly-variable R 0 4) 0 (poly* R x y)))
    (check-overflow 9 7 (poly-from-coefficients R 0 (list (cons 5 (poly-variable R 1 4)))))))

(test-case "the message of a degree overflow names degree and bound"
  (define R (make-ring 1 4))
  (check-exn #rx"degree would pass the bound of the ring.*degree: 5.*bound: 4"
             (lambda () (poly-variable R 0 5))))
