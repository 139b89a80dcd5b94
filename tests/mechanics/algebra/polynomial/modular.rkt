#lang racket/base
;; The modular parts of the gcd, each by itself.

(require racket/fixnum
         (only-in mechanics/algebra/polynomial/gcd poly-gcd)
         mechanics/algebra/polynomial/polynomial
         mechanics/algebra/polynomial/modular
         mechanics/algebra/polynomial/univariate-images
         mechanics/algebra/polynomial/interpolation
         mechanics/algebra/polynomial/heuristic-gcd
         mechanics/algebra/polynomial/sparse-gcd
         "../../support/checks.rkt" "../../support/random.rkt"
         "../../support/random/polynomial.rkt")

(define P (nth-prime 0))

;; ---------------------------------------------------------------------------
;; Fields

(define (prime? n)
  (for/and ([d (in-range 2 (+ 1 (integer-sqrt n)))]) (not (zero? (remainder n d)))))

(test-case "the primes are the greatest ones whose products fit a fixnum"
  (check-true (prime? P))
  (check-true (< P (expt 2 30)))
  (check-true (fixnum? (+ (* (- P 1) (- P 1)) P)))
  (define next (next-prime P))
  (check-true (prime? next))
  (for ([n (in-range (+ next 2) P 2)]) (check-false (prime? n))))

(test-case "inverses, powers and residues of rationals"
  (with-seeds 50
    (define a (+ 1 (random 1000000)))
    (check-equal? (modulo (* a (mod-inverse a P)) P) 1)
    (check-equal? (mod-expt a (- P 1) P) 1)
    (define c (random-coefficient))
    (check-equal? (modulo (* (residue c P) (denominator c)) P)
                  (modulo (numerator c) P)))
  (check-equal? (mod-expt 5 0 P) 1)
  (check-exn #rx"the residue has no inverse.*residue: 0" (lambda () (mod-inverse 0 P))))

(test-case "symmetric residues are least in magnitude"
  (check-equal? (for/list ([c 5]) (symmetric-residue c 5)) '(0 1 2 -2 -1)))

(test-case "univariate gcds over a prime field"
  (define (times a b)
    (define v (make-fxvector (+ (fxvector-length a) (fxvector-length b) -1) 0))
    (for* ([i (fxvector-length a)] [j (fxvector-length b)])
      (fxvector-set! v (+ i j)
                     (modulo (+ (fxvector-ref v (+ i j))
                                (* (fxvector-ref a i) (fxvector-ref b j)))
                             P)))
    v)
  (define g (fxvector 3 5 1))
  (define a (times g (fxvector 7 1 1)))
  (define b (times g (fxvector 11 1)))
  (define-values (h degree) (univariate-gcd! b 3 a 4 P))
  (check-equal? degree 2)
  (univariate-make-leading! h degree 1 P)
  (check-equal? (for/list ([i 3]) (fxvector-ref h i)) '(3 5 1)))

;; ---------------------------------------------------------------------------
;; Interpolation

(define (random-residues n)
  (for/fxvector #:length n ([_ n]) (+ 1 (random 1000000000))))

(define (value-at coefficients x)
  (for/fold ([v 0]) ([c (reverse (for/list ([c (in-fxvector coefficients)]) c))])
    (modulo (+ (* v x) c) P)))

(test-case "Newton's interpolation gives back the coefficients"
  (with-seeds 20
    (define n (+ 1 (random 8)))
    (define cs (random-residues n))
    (define points (for/list ([i n]) (+ 3 (* i i))))
    (define values (for/list ([x points]) (value-at cs x)))
    (check-equal? ((make-newton points P) values) cs)))

(test-case "power sums are solved"
  (with-seeds 20
    (define n (random 8))
    (define cs (random-residues n))
    (define ms (random-residues n))
    (define sums
      (for/fxvector #:length n ([t (in-range 1 (+ n 1))])
        (for/fold ([s 0]) ([c (in-fxvector cs)] [m (in-fxvector ms)])
          (modulo (+ s (* c (mod-expt m t P))) P))))
    (check-equal? (solve-power-sums ms sums P) cs))
  (check-false (solve-power-sums (fxvector 2 2) (fxvector 1 1) P)))

;; ---------------------------------------------------------------------------
;; Bounds and methods

(define R (make-ring 4 40))
(define indices '(0 1 2 3))

(define (primitive p)
  (define-values (c primitive) (poly-primitive R p))
  primitive)

;; Random primitive g, a g and b g that have all variables.
(define (random-problem)
  (define (full)
    (define p
      (primitive (poly+ R (random-polynomial R #:terms 6 #:degree 4)
                        (poly-sum R (for/list ([i indices]) (poly-variable R i))))))
    (if (equal? (poly-variables R p) indices) p (full)))
  (define g (full))
  (values g (primitive (poly* R g (full))) (primitive (poly* R g (full)))))

(define (degrees p) (for/list ([i indices]) (poly-degree R p i)))

(test-case "images bound the degrees of the gcd and mostly attain them"
  (with-seeds 30
    (define-values (g p q) (random-problem))
    (define bounds (gcd-degree-bounds R p q indices 0 P))
    (define true-degrees (degrees (poly-gcd R p q)))
    (check-true (andmap >= bounds true-degrees))
    (check-equal? bounds true-degrees)))

(test-case "bounds stay valid when the point or the prime is unlucky"
  (define p (poly+ R (poly-scale R P (poly-variable R 0 3)) (poly-variable R 1)))
  (check-true (andmap >= (gcd-degree-bounds R p p '(0 1) 0 P) '(3 1)))
  (for ([prime '(3 5 7)])
    (with-seeds 30
      (define-values (g p q) (random-problem))
      (check-true (andmap >= (gcd-degree-bounds R p q indices 0 prime)
                          (degrees (poly-gcd R p q)))))))

(test-case "the heuristic and the sparse method each find the gcd"
  (define found 0)
  (with-seeds 20
    (define-values (g p q) (random-problem))
    (define expected (poly-gcd R p q))
    (define d (heuristic-divisor R p q indices))
    (when d (check-equal? d expected))
    (when d (set! found (+ found 1)))
    (check-equal? (sparse-divisor R p q indices (degrees expected)
                                  (lambda (ps) (poly-gcd* R ps)) 0)
                  expected))
  (check-true (> found 15) "the heuristic method should mostly succeed"))

(test-case "with wrong degrees the sparse method fails rather than err"
  (with-seeds 10
    (define-values (g p q) (random-problem))
    (define expected (poly-gcd R p q))
    (define d (sparse-divisor R p q indices (map add1 (degrees expected))
                              (lambda (ps) (poly-gcd* R ps)) 0))
    (check-true (or (not d) (and (poly-divide R expected d) #t)))))
