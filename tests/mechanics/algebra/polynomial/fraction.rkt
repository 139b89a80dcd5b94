#lang racket/base
;; Fractions of polynomials are a field, and canonical.

(require (only-in mechanics/algebra/polynomial/gcd poly-gcd)
         mechanics/algebra/polynomial/polynomial
         mechanics/algebra/polynomial/fraction
         "../../support/checks.rkt" "../../support/random.rkt"
         "../../support/laws/law.rkt" "../../support/laws/ring.rkt"
         "../../support/random/polynomial.rkt")

;; The field of fractions, with some operations made wrong.
(define (fraction-field R #:add [add (lambda (f g) (fraction+ R f g))]
                        #:multiply [multiply (lambda (f g) (fraction* R f g))]
                        #:invert [invert (lambda (f) (fraction-invert R f))])
  (ring (fraction-from-poly R (poly-constant R 0))
        (fraction-from-poly R (poly-constant R 1))
        add
        (lambda (f g) (fraction- R f g))
        (lambda (f) (fraction-negate R f))
        multiply
        (lambda (f g) (multiply f (invert g)))
        (lambda (f) (fraction-expt R f 2))
        (lambda (f n) (fraction-expt R f n))))

;; Numerators and denominators from a few small polynomials, so that factors
;; recur; now and then a polynomial alone.
(define (random-fraction R)
  (define (small) (random-polynomial R #:terms 2 #:degree 1))
  (define p (poly* R (small) (small)))
  (define q (poly* R (small) (small)))
  (if (or (poly-zero? q) (eqv? 0 (random 3)))
      (fraction-from-poly R p)
      (fraction/ R (fraction-from-poly R p) (fraction-from-poly R q))))

(define (random-nonzero R)
  (define f (random-fraction R))
  (if (fraction-zero? f) (random-nonzero R) f))

(define (triples R n)
  (for/list ([_ (in-range n)])
    (for/list ([_ (in-range 3)]) (random-fraction R))))

;; ---------------------------------------------------------------------------
;; Laws

(define commutative-ring-laws (append ring-laws commutativity-laws power-laws))

(for ([n '(1 2 4 50)])
  (define R (make-ring n 40))
  (define title (format "fractions in ~a variables" n))
  (define (equal f g) (fraction=? R f g))
  (check-laws title commutative-ring-laws (fraction-field R)
              (lambda () (random-fraction R)) equal #:seed 1 #:rounds 100)
  (check-laws title division-laws (fraction-field R)
              (lambda () (random-nonzero R)) equal #:seed 2 #:rounds 100))

(let ()
  (define R (make-ring 2 40))
  (define (double f) (fraction-scale R 2 f))
  (define (breaks name field [equal (lambda (f g) (fraction=? R f g))])
    (check-broken name (append commutative-ring-laws division-laws) field
                  (lambda () (random-nonzero R)) equal #:seed 1))
  (breaks "an inverse cancels" (fraction-field R #:invert values))
  (breaks "the inverse of the inverse is the thing"
          (fraction-field R #:invert (lambda (f) (fraction* R f f))))
  (breaks "inverses multiply, the last one first"
          (fraction-field R #:invert (lambda (f) (double (fraction-invert R f)))))
  (breaks "multiplication distributes on the left"
          (fraction-field R #:multiply (lambda (f g) (fraction* R f (fraction* R g g)))))
  (breaks "addition associates"
          (fraction-field R #:add (lambda (f g) (fraction+ R f (double g)))))
  (breaks "addition commutes" (fraction-field R) eq?))

;; ---------------------------------------------------------------------------
;; Canonical form

(define R (make-ring 3 40))
(define (variable i) (fraction-from-poly R (poly-variable R i)))
(define x (variable 0))
(define y (variable 1))
(define z (variable 2))
(define (number c) (fraction-from-poly R (poly-constant R c)))
(define (+* . fs) (fraction-sum R fs))
(define (** . fs) (for/fold ([r (number 1)]) ([f fs]) (fraction* R r f)))
(define (/* f g) (fraction/ R f g))
(define (-* f g) (fraction- R f g))

(define (check-lowest f)
  (define p (fraction-numerator f))
  (define q (fraction-denominator R f))
  (check-true (poly-constant? (poly-gcd R p q)))
  (check-equal? (poly-content q) 1)
  (check-true (positive? (poly-leading-coefficient q)))
  (define factors (map car (fraction-denominator-factors f)))
  (for* ([f factors] [g factors] #:unless (eq? f g))
    (check-true (poly-constant? (poly-gcd R f g)))))

(test-case "results are in lowest terms over coprime factors"
  (with-seeds 10
    (for ([t (triples R 10)])
      (define-values (f g h) (apply values t))
      (for-each check-lowest
                (list f (fraction+ R f g) (fraction* R g h)
                      (+* f g h (number 1/3)) (fraction-expt R g 2)))
      (unless (fraction-zero? h)
        (check-lowest (fraction/ R f h))
        (check-lowest (fraction-expt R h -3))))))

(test-case "numerator and denominator depend on the value alone"
  (define one-way (/* (/* (number 1) (+* x y)) (+* x y)))
  (define other (/* (number 1) (+* (** x x) (** (number 2) x y) (** y y))))
  (check-not-equal? (fraction-denominator-factors one-way)
                    (fraction-denominator-factors other))
  (check-true (fraction=? R one-way other))
  (check-equal? (fraction-hash R one-way) (fraction-hash R other))
  (check-true (fraction-zero? (-* one-way other)))
  (check-equal? (fraction-denominator R one-way) (fraction-denominator R other))
  (check-equal? (fraction-denominator-parts R one-way) (fraction-denominator-parts R other)))

(test-case "the parts of a denominator depend on the value alone"
  (with-seeds 10
    (define-values (f g h) (apply values (for/list ([_ 3]) (random-fraction R))))
    (unless (ormap fraction-zero? (list f g h))
      (define one-way (/* (/* (number 1) f) (** g h)))
      (define other (/* (/* (/* (number 1) h) g) f))
      (check-true (fraction=? R one-way other))
      (check-equal? (fraction-denominator-parts R one-way)
                    (fraction-denominator-parts R other))
      (check-equal? (for/fold ([p (poly-constant R 1)])
                              ([part (fraction-denominator-parts R one-way)])
                      (poly* R p (poly-expt R (car part) (cdr part))))
                    (fraction-denominator R one-way)))))

(test-case "different fractions are not fraction=?"
  (check-false (fraction=? R (/* x y) (/* x z)))
  (check-false (fraction=? R (/* x y) (/* y x)))
  (check-false (fraction=? R (/* x (** y y)) (/* x y)))
  (check-false (fraction=? R (/* x (+* y z)) (/* x (+* y (number 1))))))

(test-case "common factors cancel in sums, also when they are only part of a factor"
  (define a (+* x y))
  (define b (-* x y))
  (check-true (fraction=? R (+* (/* x a) (/* y a)) (number 1)))
  (check-true (fraction=? R (-* (/* x b) (/* y b)) (number 1)))
  ;; 1/(x²-y²) · x + 1/(x²-y²) · y = 1/(x-y), where x²-y² is one factor
  (define ab (-* (** x x) (** y y)))
  (define sum (+* (/* x ab) (/* y ab)))
  (check-true (fraction=? R sum (/* (number 1) b)))
  (check-equal? (fraction-denominator-factors sum)
                (list (cons (fraction-numerator b) 1)))
  ;; the same with powers
  (define sum² (+* (/* x (** ab ab)) (/* y (** ab ab))))
  (check-true (fraction=? R sum² (/* (number 1) (** a b b)))))

(test-case "the sum of many fractions is their sum one by one"
  (with-seeds 10
    (define fs (for/list ([_ 12]) (random-fraction R)))
    (check-true (fraction=? R (fraction-sum R fs)
                            (for/fold ([s (number 0)]) ([f fs]) (fraction+ R s f)))))
  (check-true (fraction-zero? (fraction-sum R '()))))

(test-case "powers, also negative ones"
  (define f (/* (+* x y) (** y z)))
  (check-true (fraction=? R (fraction-expt R f 3) (** f f f)))
  (check-true (fraction=? R (fraction-expt R f -2) (/* (number 1) (** f f))))
  (check-true (fraction=? R (fraction-expt R f 0) (number 1))))

(test-case "a polynomial has no denominator, and it comes back"
  (define p (poly+ R (poly-variable R 0) (poly-constant R 1/2)))
  (check-equal? (fraction-numerator (fraction-from-poly R p)) p)
  (check-equal? (fraction-denominator-factors (fraction-from-poly R p)) '())
  (check-equal? (fraction-denominator R (fraction-from-poly R p)) (poly-constant R 1))
  (check-true (fraction-polynomial? (/* (** x y) y)))
  (check-false (fraction-polynomial? (/* x y))))

(test-case "division by zero raises"
  (check-exn exn:fail:contract:divide-by-zero? (lambda () (/* x (-* y y))))
  (check-exn exn:fail:contract:divide-by-zero? (lambda () (fraction-expt R (number 0) -1))))
