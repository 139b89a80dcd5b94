#lang racket/base
;; Packed monomials, in rings of one word and of several.

(require mechanics/algebra/polynomial/monomial
         mechanics/algebra/polynomial/ring
         "../../support/checks.rkt" "../../support/random.rkt")

;; Sizes and degrees on both sides of the word boundaries.
(define shapes
  (for*/list ([n '(1 2 9 10 11 12 13 21 22 23 50)] [degree '(1 15 16 1000)])
    (list n degree)))

(define-syntax-rule (in-shapes (R n degree) body ...)
  (for ([shape (in-list shapes)])
    (define-values (n degree) (apply values shape))
    (define R (make-ring n degree))
    (with-check-info (['variables n] ['degree degree])
      body ...)))

;; Exponents whose sum is at most `degree`.
(define (random-exponents n degree)
  (define v (make-vector n 0))
  (for ([_ (in-range (random (+ 1 degree)))])
    (define i (random n))
    (vector-set! v i (+ 1 (vector-ref v i))))
  v)

(define (exponents->monomial R exponents)
  (for/fold ([m (ring-one R)]) ([e exponents] [i (in-naturals)])
    (check-monomial R (monomial+ m (variable-monomial R i e)))))

(define (monomial-exponents R m)
  (for/vector ([i (ring-size R)]) (monomial-exponent R m i)))

(define (total v) (for/sum ([e v]) e))
(define (halves n degree)
  (values (random-exponents n (quotient degree 2)) (random-exponents n (quotient degree 2))))

(define (graded-greater? u v)
  (define d (- (total u) (total v)))
  (if (zero? d)
      (for/first ([a u] [b v] #:unless (= a b)) (> a b))
      (> d 0)))

(test-case "exponents packed come back, one by one and together"
  (with-seeds 3
    (in-shapes (R n degree)
      (define v (random-exponents n degree))
      (define m (exponents->monomial R v))
      (check-equal? (monomial-exponents R m) v)
      (check-equal? (monomial-degree R m) (total v))
      (check-equal? (monomial-factors R m)
                    (for/list ([e v] [i (in-naturals)] #:unless (zero? e)) (cons i e)))
      (check-equal? (monomial-one? m) (zero? (total v))))))

(test-case "the greatest exponent fits every field"
  (in-shapes (R n degree)
    (for ([i n])
      (define m (variable-monomial R i degree))
      (check-equal? (monomial-factors R m) (list (cons i degree)))
      (check-equal? (monomial-degree R m) degree))))

(test-case "sums of exponents are sums of monomials"
  (with-seeds 3
    (in-shapes (R n degree)
      (define-values (u v) (halves n degree))
      (define a (exponents->monomial R u))
      (define b (exponents->monomial R v))
      (define ab (monomial+ a b))
      (check-equal? (monomial-exponents R ab) (for/vector ([x u] [y v]) (+ x y)))
      (check-equal? (monomial- ab b) a)
      (check-equal? (monomial+ a a) (monomial-power a 2)))))

(test-case "the order is graded lexicographic"
  (with-seeds 5
    (in-shapes (R n degree)
      (define-values (u v) (halves n degree))
      (define a (exponents->monomial R u))
      (define b (exponents->monomial R v))
      (check-equal? (monomial>? a b) (graded-greater? u v))
      (check-equal? (monomial>? b a) (graded-greater? v u))
      (check-equal? (monomial=? a b) (equal? u v)))))

(test-case "divisibility, common divisors and parts go by exponents"
  (with-seeds 5
    (in-shapes (R n degree)
      (define-values (u v) (halves n degree))
      (define a (exponents->monomial R u))
      (define b (exponents->monomial R v))
      (define guards (ring-guards R))
      (check-equal? (monomial-divides? guards a b) (for/and ([x u] [y v]) (<= x y)))
      (check-true (monomial-divides? guards a (monomial+ a b)))
      (check-equal? (monomial-exponents R (monomial-gcd R a b))
                    (for/vector ([x u] [y v]) (min x y)))
      (define even (for/list ([i n] #:when (even? i)) i))
      (check-equal? (monomial-exponents R ((monomial-part R even) a))
                    (for/vector ([x u] [i (in-naturals)]) (if (even? i) x 0))))))

(test-case "equal monomials hash alike and work as keys"
  (with-seeds 2
    (in-shapes (R n degree)
      (define v (random-exponents n degree))
      (define a (exponents->monomial R v))
      (define b (exponents->monomial R (vector->list v)))
      (define table (make-monomial-hash R))
      (hash-set! table a 'found)
      (check-equal? (hash-ref table b #f) 'found)
      (check-equal? (monomial-hash a) (monomial-hash b)))))

(test-case "degrees that fit no field are refused"
  (check-true (ring? (make-ring 3 (- (expt 2 28) 1))))
  (check-exn #rx"make-ring: contract violation.*degree below 2\\^28"
             (lambda () (make-ring 3 (expt 2 28)))))
