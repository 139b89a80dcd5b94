#lang racket/base
;; Roots that are products of others: √6 = √2 √3, √(xy) = √x √y, ∜12 ² = 2 √3.
;;
;; Radicands are written over a coprime basis of polynomials, their numbers over
;; primes and -1.  Modulo whole powers of the basis the root u^(1/q) is the
;; vector of its exponents, fractions with the denominator q.  Its least power
;; whose vector is an integer combination of those of other roots uᵢ^(1/qᵢ)
;; depends on them,
;;
;;     (u^(1/q))^k = w ∏ (uᵢ^(1/qᵢ))^mᵢ,
;;
;; if no element of the basis is negative, which has to be assumed.

(require "lattice.rkt" "exact.rkt" "polynomial/polynomial.rkt" "polynomial/fraction.rkt"
         "polynomial/coprime-basis.rkt")

(provide root-dependence)

;; u, us : fractions, not zero; q, qs : the degrees of their roots
;; -> k, the mᵢ as ((position in us . exponent) ...), the fraction w, and the
;; polynomials of the basis that occur in u.  Where no lower power will do, k is
;; q, w is u and no more is said.
(define (root-dependence R u q us qs)
  (define basis
    (for/fold ([basis '()]) ([v (in-list (cons u us))] [i (in-naturals)]) (insert R basis v i)))
  (define numbers (map number-part (cons u us)))
  (define factored (for/list ([c (in-list numbers)]) (number-factors (abs c))))
  (define primes (distinct (map car (apply append factored))))
  (define modulus (apply lcm q qs))
  (define exponents                     ; of basis elements in the i-th radicand
    (for/list ([c (in-list numbers)] [factors (in-list factored)] [i (in-naturals)])
      (append (list (if (negative? c) 1 0))
              (for/list ([p (in-list primes)]) (exponent (cons p factors) p))
              (for/list ([b (in-list basis)]) (exponent b i)))))
  (define vectors
    (for/list ([es (in-list exponents)] [q (in-list (cons q qs))])
      (sparse (for/list ([e (in-list es)]) (modulo (* e (/ modulus q)) modulus)))))
  (define size (length (car exponents)))
  (define-values (k combination) (least-power (car vectors) q (cdr vectors) size modulus))
  (cond [(not combination) (values q '() u '())]
        [else
         (define members
           (for/list ([m (in-list combination)] [q (in-list qs)] [i (in-naturals)]
                      #:unless (eqv? 0 (modulo m q)))
             (cons i (modulo m q))))
         (define (left-over es)         ; exponents of one basis element
           (- (/ (* k (car es)) q)
              (for/sum ([m (in-list members)])
                (/ (* (cdr m) (list-ref (cdr es) (car m))) (list-ref qs (car m))))))
         (values k members
                 (product R (append (list -1) primes (map car basis))
                          (map left-over (transpose exponents)))
                 (for/list ([b (in-list basis)] #:when (assv 0 (cdr b))) (car b)))]))

;; The least proper divisor k of q for which k v is a combination of the vectors,
;; and the combination; or #f #f.
(define (least-power v q vectors size modulus)
  (let loop ([k 1])
    (cond [(eqv? k q) (values #f #f)]
          [(eqv? 0 (remainder q k))
           (define combination
             (integer-combination (vector-scale k v) vectors size modulus))
           (if combination (values k combination) (loop (+ k 1)))]
          [else (loop (+ k 1))])))

(define (sparse xs)
  (for/list ([x (in-list xs)] [i (in-naturals)] #:unless (eqv? x 0)) (cons i x)))

(define (transpose rows) (apply map list rows))

;; ∏ factor^exponent, of numbers and polynomials.
(define (product R factors exponents)
  (for/fold ([w (fraction-from-poly R (poly-constant R 1))])
            ([f (in-list factors)] [e (in-list exponents)])
    (if (number? f)
        (fraction-scale R (expt f e) w)
        (fraction* R w (fraction-expt R (fraction-from-poly R f) e)))))

;; ---------------------------------------------------------------------------
;; Bases

;; A basis element is (polynomial . ((i . exponent of it in the i-th radicand) ...)).
(define (insert R basis v i)
  (define-values (content primitive) (poly-primitive R (fraction-numerator v)))
  (for/fold ([basis (basis-insert R vector-add basis primitive (list (cons i 1)))])
            ([h (in-list (fraction-denominator-factors v))])
    (basis-insert R vector-add basis (car h) (list (cons i (- (cdr h)))))))

(define (exponent b i)
  (define entry (assv i (cdr b)))
  (if entry (cdr entry) 0))

;; The number in a radicand whose polynomials are primitive.
(define (number-part v)
  (define p (fraction-numerator v))
  (define c (poly-content p))
  (if (negative? (poly-leading-coefficient p)) (- c) c))

(define (distinct xs)
  (for/fold ([kept '()] #:result (reverse kept)) ([x (in-list xs)])
    (if (memv x kept) kept (cons x kept))))
