#lang racket/base
;; The greatest common divisor: its laws for the gcd as a whole and for the
;; remainder sequences alone, and hard cases.

(require (only-in mechanics/algebra/polynomial/gcd poly-gcd)
         (only-in mechanics/algebra/polynomial/modular nth-prime)
         (only-in mechanics/algebra/polynomial/sparse-gcd sparse-divisor)
         (only-in mechanics/algebra/polynomial/square-free poly-square-free)
         mechanics/algebra/polynomial/polynomial
         (only-in mechanics/algebra/polynomial/remainder-gcd remainder-gcd)
         "../../support/checks.rkt" "../../support/random.rkt"
         "../../support/laws/law.rkt"
         "../../support/random/polynomial.rkt")

;; ---------------------------------------------------------------------------
;; Laws

(define (primitive R p)
  (define-values (c primitive) (poly-primitive R p))
  primitive)

;; of : polynomial polynomial -> their greatest common divisor
(struct gcd-in (ring of))

(define (divides? R p q)
  (if (poly-zero? p) (poly-zero? q) (and (poly-divide R q p) #t)))

(define-laws gcd-laws
  ([R gcd-in-ring] [gcd gcd-in-of])
  ["divides the one" (p q) (divides? R (gcd p q) p) #t]
  ["divides the other" (p q) (divides? R (gcd p q) q) #t]
  ["commutes" (p q) (gcd p q) (gcd q p)]
  ["takes common factors out" (p q r)
   (gcd (poly* R p r) (poly* R q r))
   (primitive R (poly* R (gcd p q) r))]
  ["is primitive with positive leading coefficient" (p q)
   (gcd p q) (primitive R (gcd p q))]
  ["with zero is the primitive part" (p)
   (gcd p (poly-constant R 0)) (primitive R p)])

(define ((draw R terms degree)) (random-polynomial R #:terms terms #:degree degree))

(for ([shape '((1 6 8) (2 6 5) (3 6 4) (6 8 4) (6 30 6) (50 8 4))])
  (define-values (n terms degree) (apply values shape))
  (define R (make-ring n (* 2 degree)))
  (check-laws (format "gcd of ~a terms of degree ~a in ~a variables" terms degree n)
              gcd-laws (gcd-in R (lambda (p q) (poly-gcd R p q)))
              (draw R terms degree) equal? #:seed 1 #:rounds 24))

(for ([n '(1 2 3)])
  (define R (make-ring n 12))
  (define (gcd-by-remainders p q)
    (cond [(poly-zero? p) (primitive R q)]
          [(poly-zero? q) (primitive R p)]
          [else (remainder-gcd R p q)]))
  (check-laws (format "remainder sequences in ~a variables" n)
              gcd-laws (gcd-in R gcd-by-remainders) (draw R 3 2) equal? #:seed 1 #:rounds 16))

(let ()
  (define R (make-ring 3 24))
  (define (breaks name wrong)
    (check-broken name gcd-laws (gcd-in R wrong) (draw R 4 3) equal? #:seed 1))
  (breaks "divides the one" (lambda (p q) (poly* R p q)))
  (breaks "divides the other" (lambda (p q) (poly* R p q)))
  (breaks "commutes" (lambda (p q) (primitive R p)))
  (breaks "takes common factors out" (lambda (p q) (poly-constant R 1)))
  (breaks "is primitive with positive leading coefficient"
          (lambda (p q) (poly-scale R -2 (poly-gcd R p q))))
  (breaks "with zero is the primitive part" (lambda (p q) (poly-constant R 1))))

;; ---------------------------------------------------------------------------
;; Cases

(define R (make-ring 6 30))
(define (number c) (poly-constant R c))
(define (variable i) (poly-variable R i))
(define (sum . ps) (poly-sum R ps))
(define (product . ps) (for/fold ([r (number 1)]) ([p ps]) (poly* R r p)))
(define-values (x y z u v w) (apply values (for/list ([i 6]) (variable i))))

(define (check-gcd p q expected)
  (check-equal? (poly-gcd R p q) expected)
  (check-equal? (poly-gcd R q p) expected))

(test-case "monomials, constants and zeros"
  (check-gcd (product x x y) (product x y z) (product x y))
  (check-gcd (product x (sum y z)) (product x x) x)
  (check-gcd (number 4) (number 6) (number 1))
  (check-gcd (number 0) (number 0) (number 0))
  (check-gcd (number 0) (poly-scale R -6 x) x)
  (check-gcd (number 3/2) x (number 1)))

(test-case "variables in only one operand are no part of the gcd"
  (check-gcd (product (sum x (number 1)) (sum y (number 2)))
             (product (sum x (number 1)) (sum z (number 2)))
             (sum x (number 1)))
  (check-gcd (sum (product x u) (product y v)) (sum (product x w) z) (number 1))
  (define g (sum (product x y) (number 3)))
  (check-gcd (product g (sum u v (product u w))) (product g (sum (product x x) y)) g))

(test-case "factors free of the main variable are found"
  (define free (sum (product y z) (number 1)))
  (check-gcd (product free (sum x y)) (product free (sum x z)) free)
  (check-gcd (product free (sum x y) (sum x (number 1)))
             (product free (sum x z) (sum x (number 1)))
             (product free (sum x (number 1)))))

(test-case "a gcd with non-trivial leading coefficients in every variable"
  (define g (sum (product x y z) (poly-scale R 2 (product x z)) (poly-scale R 3 (product y x))
                 (poly-scale R 5 (product y z)) (number 7)))
  (define a (sum (product x y (sum z (number 4))) (number 1)))
  (define b (sum (product x y (sum u z)) (product z x) (number 2)))
  (check-gcd (product g g a) (product g b) g)
  (check-gcd (product g g a) (product g g b) (product g g)))

(test-case "coefficients that vanish modulo one of the primes are found from the others"
  (define (gcd-of ps) (for/fold ([g (number 0)]) ([p ps]) (poly-gcd R g p)))
  (for ([n 3])
    (define P (nth-prime n))
    (define g (sum (product x x y) (poly-scale R P (product y z)) (poly-scale R (* 2 P) x)
                   (poly-scale R (+ P 5) z) (number 3)))
    (define-values (p q) (values (product g (sum x y (number 1))) (product g (sum x z (number 2)))))
    (check-gcd p q g)
    (when (> n 0) (check-equal? (sparse-divisor R p q '(0 1 2) '(2 1 1) gcd-of 0) g))))

(test-case "coefficients beyond many primes"
  (define big (expt 7 200))
  (define g (sum (poly-scale R big (product x x y)) (poly-scale R (+ big 2) z) (number 3)
                 (product u v) (product u w w)))
  (define a (sum (poly-scale R (* 3 big) x) y z u v w (number 1)))
  (define b (sum (poly-scale R (- big 1) (product x y)) z u v w (number 5)))
  (check-gcd (product g a) (product g b) g))

(test-case "coefficients divisible by the first prime"
  (define P 1073741789)
  (define g (sum (poly-scale R P (product x y)) (product z u) (number 1)))
  (define a (sum (poly-scale R P x) y))
  (define b (sum (poly-scale R P x) (poly-scale R P z) (number 2)))
  (check-gcd (product g a) (product g b) g)
  (check-gcd a b (number 1)))

(test-case "conjugates that agree at many points are coprime"
  (check-gcd (sum (product x x) (number 1)) (sum (product x x) (number -1)) (number 1))
  (define p (for/fold ([p (number 1)]) ([i 10]) (product p (sum x (number i)))))
  (check-gcd (sum p y) (sum p z) (number 1))
  (check-gcd (sum p y) (sum p (poly-scale R 2 y)) (number 1)))

(test-case "the gcd of a list divides all and takes common factors out"
  (with-seeds 10
    (define g (random-polynomial R #:terms 5 #:degree 3))
    (define ps (for/list ([_ 6]) (random-polynomial R #:terms 5 #:degree 3)))
    (unless (poly-zero? g)
      (check-equal? (poly-gcd* R (for/list ([p ps]) (poly* R g p)))
                    (primitive R (poly* R g (poly-gcd* R ps))))))
  (check-true (poly-zero? (poly-gcd* R '()))))

;; ---------------------------------------------------------------------------
;; Square-free decomposition

(test-case "the square-free factors multiply to the polynomial and are coprime and square-free"
  (define R (make-ring 3 40))
  (with-seeds 20
    (define-values (a b c)
      (apply values (for/list ([_ 3]) (random-polynomial R #:terms 3 #:degree 2))))
    (define p (poly* R a (poly* R (poly-expt R b 2) (poly-expt R c 3))))
    (unless (poly-zero? p)
      (define factors (poly-square-free R p))
      (check-equal? (for/fold ([r (poly-constant R 1)]) ([f factors])
                      (poly* R r (poly-expt R (car f) (cdr f))))
                    (primitive R p))
      (for ([f factors])
        (check-equal? (poly-square-free R (car f)) (list (cons (car f) 1)))
        (for ([g factors] #:unless (eq? f g))
          (check-true (poly-constant? (poly-gcd R (car f) (car g)))))))))

(test-case "the square-free decomposition finds multiplicities"
  (define p (sum x y))
  (define q (sum (product x z) (number 1)))
  (check-equal? (sort (poly-square-free R (product (number 6) p p p q z z)) < #:key cdr)
                (list (cons q 1) (cons z 2) (cons p 3)))
  (check-equal? (poly-square-free R (number 5)) '()))

;; ---------------------------------------------------------------------------
;; Parts

(define (check-parts p . expected)
  (define (as-set parts) (for/hash ([part parts]) (values (car part) (cdr part))))
  (check-equal? (as-set (poly-parts R p)) (as-set expected)))

(test-case "parts go by variables and multiplicities, dividing variables apart"
  (define x+1 (sum x (number 1)))
  (define x-1 (sum x (number -1)))
  (define y+z (sum y z))
  (define xy+1 (sum (product x y) (number 1)))
  (check-parts (number 6))
  (check-parts (product (number 6) x x y) (cons x 2) (cons y 1))
  (check-parts (product x+1 x-1) (cons (product x+1 x-1) 1))
  (check-parts (product x x+1 x-1 x-1) (cons x 1) (cons x+1 1) (cons x-1 2))
  (check-parts (product x+1 y+z xy+1) (cons x+1 1) (cons y+z 1) (cons xy+1 1))
  (check-parts (product x+1 x+1 y+z y+z z) (cons x+1 2) (cons y+z 2) (cons z 1)))
