#lang racket/base
;; Rational functions in lowest terms.
;;
;; A fraction is a numerator over the rationals and a denominator kept as a
;; product of powers of pairwise coprime factors, each primitive over the
;; integers with positive leading coefficient; variables are factors of their
;; own.  So the common denominator of two fractions is read off their factors,
;; and only factors that both have to the same power can cancel in their sum:
;; a prime that divides one denominator oftener than the other divides just one
;; of the two terms over the common denominator.
;;
;; The value is canonical: numerator and expanded denominator depend on it
;; alone.  How the denominator is split into factors depends on its history;
;; fraction-denominator-parts splits it in a way that does not.

(require racket/list
         "arithmetic.rkt" "content.rkt" "coprime-basis.rkt" "division.rkt" "gcd.rkt"
         "gcd-splitting.rkt" "polynomial-parts.rkt" "power.rkt" "ring-change.rkt"
         "../../error/complain.rkt")

(provide
 ;; making
 fraction? fraction-from-poly fraction-constant fraction-rering
 ;; parts
 fraction-numerator fraction-denominator-factors fraction-denominator-parts
 fraction-denominator fraction-denominator-degree
 ;; asking
 fraction-zero? fraction-polynomial? fraction-number fraction=? fraction-hash
 ;; arithmetic
 fraction+ fraction- fraction-negate fraction-scale fraction-sum
 fraction* fraction/ fraction-invert fraction-expt fraction-product)

;; denominator-factors : powers (power.rkt) of polynomials
(struct fraction (numerator denominator-factors)
  #:authentic)

(define (fraction-from-poly R p) (fraction p '()))
(define (fraction-constant R c) (fraction (poly-constant R c) '()))

;; The fraction f of the ring `from`, in the ring `to`.
(define (fraction-rering from to f)
  (fraction (rering from to (fraction-numerator f))
            (for/list ([h (in-list (fraction-denominator-factors f))])
              (make-power (rering from to (power-base h)) (power-exponent h)))))

;; The parts of the denominator (gcd-splitting.rkt), which depend on the value alone.
(define (fraction-denominator-parts R f)
  (product-parts R (fraction-denominator-factors f)))

;; The denominator multiplied out.
(define (fraction-denominator R f)
  (expand R (poly-constant R 1) (fraction-denominator-factors f)))

;; p times a product of powers.
(define (expand R p factors)
  (for/fold ([p p]) ([f (in-list factors)])
    (poly* R p (poly-expt R (power-base f) (power-exponent f)))))

;; ---------------------------------------------------------------------------
;; Predicates

(define (fraction-zero? f) (poly-zero? (fraction-numerator f)))
(define (fraction-polynomial? f) (null? (fraction-denominator-factors f)))

;; The number that f is, or #f.
(define (fraction-number f)
  (define p (fraction-numerator f))
  (and (fraction-polynomial? f) (poly-constant? p) (poly-constant-value p)))

;; Denominators split differently are compared over a common basis.
(define (fraction=? R f g)
  (define F (fraction-denominator-factors f))
  (define G (fraction-denominator-factors g))
  (and (poly=? (fraction-numerator f) (fraction-numerator g))
       (or (basis=? F G)
           (for/and ([h (in-list (common-basis R F G))])
             (define e (power-exponent h))
             (eqv? (exponents-first e) (exponents-second e))))))

;; Equal fractions have equal hashes, however their denominators are split.
(define (fraction-hash R f)
  (bitwise-and (+ (poly-hash (fraction-numerator f)) (* 7919 (fraction-denominator-degree R f)))
               #xFFFFFFFFFFFF))

(define (fraction-denominator-degree R f)
  (for/sum ([h (in-list (fraction-denominator-factors f))])
    (* (power-exponent h) (poly-total-degree R (power-base h)))))

;; ---------------------------------------------------------------------------
;; Sums

(define (fraction-negate R f)
  (fraction (poly-negate R (fraction-numerator f)) (fraction-denominator-factors f)))

(define (fraction-scale R c f)
  (if (eqv? c 0)
      (fraction '() '())
      (fraction (poly-scale R c (fraction-numerator f)) (fraction-denominator-factors f))))

(define (fraction- R f g) (fraction+ R f (fraction-negate R g)))

(define (fraction+ R f g)
  (define F (fraction-denominator-factors f))
  (define G (fraction-denominator-factors g))
  (cond [(basis=? F G)
         (cancel R (poly+ R (fraction-numerator f) (fraction-numerator g)) F)]
        [(fraction-zero? f) g]
        [(fraction-zero? g) f]
        [else (add-over R f g (common-basis R F G))]))

;; Of one factor in two denominators.
(struct exponents (first second) #:authentic)

(define (add-exponents a b)
  (exponents (+ (exponents-first a) (exponents-first b))
             (+ (exponents-second a) (exponents-second b))))

;; The factors of two denominators, with their exponents in both.
(define (common-basis R F G)
  (define of-f
    (for/list ([h (in-list F)])
      (make-power (power-base h) (exponents (power-exponent h) 0))))
  (for/fold ([basis of-f]) ([h (in-list G)])
    (basis-insert R add-exponents basis (power-base h) (exponents 0 (power-exponent h)))))

(define (add-over R f g basis)
  (define (factors exponent)            ; those to a positive power
    (for*/fold ([factors '()])
               ([h (in-list basis)]
                [es (in-value (power-exponent h))]
                [e (in-value (exponent (exponents-first es) (exponents-second es)))]
                #:when (positive? e))
      (cons (make-power (power-base h) e) factors)))
  (cancel R
          (poly+ R
                 (expand R (fraction-numerator f) (factors (lambda (a b) (- b a))))
                 (expand R (fraction-numerator g) (factors -)))
          (factors (lambda (a b) (if (= a b) a 0)))
          (factors (lambda (a b) (if (= a b) 0 (max a b))))))

;; Fractions over one denominator are added first.
(define (fraction-sum R fs)
  (define groups (group-by fraction-denominator-factors fs basis=?))
  (sum-of-neighbours (lambda (f g) (fraction+ R f g))
                     (for/list ([group (in-list groups)]) (sum-group R group))
                     (fraction '() '())))

(define (sum-group R group)
  (if (null? (cdr group))
      (car group)
      (cancel R
              (poly-sum R (map fraction-numerator group))
              (fraction-denominator-factors (car group)))))

;; ---------------------------------------------------------------------------
;; Products

(define (fraction* R f g)
  (define p (fraction-numerator f))
  (define q (fraction-numerator g))
  (define F (fraction-denominator-factors f))
  (define G (fraction-denominator-factors g))
  (cond [(and (null? F) (null? G)) (fraction (poly* R p q) '())]
        [(or (null? p) (null? q)) (fraction '() '())]
        [else
         (define-values (p* G*) (cancel-all R p G))
         (define-values (q* F*) (cancel-all R q F))
         (fraction (poly* R p* q*) (basis-sort (multiply-bases R F* G*)))]))

(define (multiply-bases R F G)
  (for/fold ([basis F]) ([h (in-list G)])
    (basis-insert R + basis (power-base h) (power-exponent h))))

(define (fraction/ R f g) (fraction* R f (fraction-invert R g)))

(define (fraction-invert R f)
  (define p (fraction-numerator f))
  (when (null? p) (raise-division-by-zero 'fraction/))
  (define-values (content factors) (split-factors R p))
  (fraction (expand R (poly-constant R (/ 1 content)) (fraction-denominator-factors f))
            (basis-sort factors)))

;; A polynomial as a rational number, variables, and the primitive rest.
(define (split-factors R p)
  (define-values (content primitive) (poly-primitive R p))
  (define-values (variables rest) (split-monomial R primitive))
  (values content
          (if (poly-constant? rest) variables (cons (make-power rest 1) variables))))

(define (fraction-expt R f k)
  (cond [(negative? k) (fraction-expt R (fraction-invert R f) (- k))]
        [(eqv? k 0) (fraction-constant R 1)]
        [else
         (fraction (poly-expt R (fraction-numerator f) k)
                   (raise-powers (fraction-denominator-factors f) k))]))

;; The product of powers of numbers and polynomials.
(define (fraction-product R powers)
  (for/fold ([product (fraction-constant R 1)]) ([h (in-list powers)])
    (define b (power-base h))
    (define e (power-exponent h))
    (if (number? b)
        (fraction-scale R (expt b e) product)
        (fraction* R product (fraction-expt R (fraction-from-poly R b) e)))))

;; ---------------------------------------------------------------------------
;; Cancelling

;; The fraction p / (factors · settled), where only `factors` may share
;; divisors with p.
(define (cancel R p factors [settled '()])
  (cond [(null? p) (fraction '() '())]
        [(null? factors) (fraction p (basis-sort settled))]
        [else
         (define-values (p* rest) (cancel-all R p factors))
         (fraction p* (basis-sort (append rest settled)))]))

;; -> p and factors without their common divisors.
(define (cancel-all R p factors)
  (for/fold ([p p] [kept '()]) ([h (in-list factors)])
    (define-values (p* rest) (cancel-power R p (power-base h) (power-exponent h)))
    (values p* (append rest kept))))

;; The same against h^e.  When they share a proper divisor d of h, the
;; remaining denominator d^(e-1) (h/d)^e is refined and tried again.
(define (cancel-power R p h e)
  (define d (poly-gcd R p h))
  (cond [(poly-constant? d) (values p (list (make-power h e)))]
        [else
         (define p* (poly-divide R p d))
         (define others (basis-insert R + '() (poly-divide R h d) e))
         (cancel-all R p* (if (eqv? e 1)
                              others
                              (basis-insert R + others d (- e 1))))]))
