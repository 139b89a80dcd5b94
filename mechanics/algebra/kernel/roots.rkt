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
;; if no element of the basis is negative.  A negative element is replaced by its
;; opposite, and the exponents of -1 keep its sign.

(require racket/list
         "integer-lattice.rkt"
         "../expression/exact-numbers.rkt"
         "../polynomial/coprime-basis.rkt" "../polynomial/fraction.rkt"
         "../polynomial/polynomial.rkt")

(provide root-dependence)

;; u, us : fractions, not zero; q, qs : the degrees of their roots
;; branch : polynomial -> 1 or -1, as its sign is known or taken to be, or #f; asked
;; of those in u and in the roots it depends on
;; -> k, the mᵢ as ((position in us . exponent) ...) and the fraction w.  Where no
;; lower power will do, or a sign is missing, k is q and w is u.
(define (root-dependence R u q us qs branch)
  (define all (cons u us))
  (define basis
    (for/fold ([basis '()]) ([v (in-list all)] [i (in-naturals)]) (insert R basis v i)))
  (define numbers (map number-part all))
  (let try ([signs (map (lambda (b) #f) basis)])
    (define-values (k members w) (dependence R basis signs numbers q qs))
    (define more (and k (known-signs basis signs members branch)))
    (cond [(not more) (values q '() u)]        ; no dependence, or a sign is missing
          [(equal? more signs) (values k members w)]
          [else (try more)])))

;; The signs with those of the elements that occur in u and the members; #f if one
;; is not known.
(define (known-signs basis signs members branch)
  (define more
    (for/list ([b (in-list basis)] [s (in-list signs)])
      (cond [s s]
            [(occurs? b members) (or (branch (power-base b)) 'unknown)]
            [else #f])))
  (and (not (memq 'unknown more)) more))

(define (occurs? b members)
  (or (assv 0 (power-exponent b))
      (for/or ([m (in-list members)]) (assv (+ 1 (car m)) (power-exponent b)))))

(define (dependence R basis signs numbers q qs)
  (define factored (for/list ([c (in-list numbers)]) (number-factors (abs c))))
  (define primes (remove-duplicates (map car (append* factored)) eqv?))
  (define exponents                     ; of all elements in the i-th radicand
    (for/list ([c (in-list numbers)] [factors (in-list factored)] [i (in-naturals)])
      (append (list (sign-exponent c basis signs i))
              (for/list ([p (in-list primes)]) (coordinate factors p))
              (for/list ([b (in-list basis)]) (exponent b i)))))
  (define modulus (apply lcm q qs))
  (define vectors
    (for/list ([es (in-list exponents)] [q (in-list (cons q qs))])
      (sparse (for/list ([e (in-list es)]) (modulo (* e (/ modulus q)) modulus)))))
  (define-values (k combination)
    (least-power (car vectors) q (cdr vectors) (length (car exponents)) modulus))
  (define members
    (for/list ([m (in-list (or combination '()))] [q (in-list qs)] [i (in-naturals)]
               #:unless (eqv? 0 (modulo m q)))
      (cons i (modulo m q))))
  (define elements
    (append (cons -1 primes)
            (for/list ([b (in-list basis)] [s (in-list signs)])
              (if (eqv? s -1) (poly-negate R (power-base b)) (power-base b)))))
  (values k members (and k (left-over R elements exponents k q members qs))))

;; Of -1, in the i-th radicand with the number c in it.
(define (sign-exponent c basis signs i)
  (modulo (+ (if (negative? c) 1 0)
             (for/sum ([b (in-list basis)] [s (in-list signs)])
               (if (eqv? s -1) (exponent b i) 0)))
          2))

;; w, the k-th power of the root over the members.
(define (left-over R elements exponents k q members qs)
  (fraction-product R
    (for/list ([x (in-list elements)] [es (in-list (transpose exponents))])
      (make-power x
                  (- (/ (* k (car es)) q)
                     (for/sum ([m (in-list members)])
                       (/ (* (cdr m) (list-ref (cdr es) (car m))) (list-ref qs (car m)))))))))

;; The least proper divisor k of q for which k v is a combination of the vectors,
;; and the combination; or #f #f.
(define (least-power v q vectors size modulus)
  (let loop ([k 1])
    (define combination
      (and (< k q)
           (eqv? 0 (remainder q k))
           (integer-combination (vector-scale k v) vectors size modulus)))
    (cond [combination (values k combination)]
          [(< k q) (loop (+ k 1))]
          [else (values #f #f)])))

(define (sparse xs)
  (for/list ([x (in-list xs)] [i (in-naturals)] #:unless (eqv? x 0)) (cons i x)))

(define (transpose rows) (apply map list rows))

;; ---------------------------------------------------------------------------
;; Bases

;; A basis element is a power of a polynomial, whose exponent is a sparse vector:
;; ((i . exponent of it in the i-th radicand) ...).
(define (insert R basis v i)
  (define-values (content primitive) (poly-primitive R (fraction-numerator v)))
  (for/fold ([basis (basis-insert R vector-add basis primitive (list (cons i 1)))])
            ([h (in-list (fraction-denominator-factors v))])
    (basis-insert R vector-add basis (power-base h) (list (cons i (- (power-exponent h)))))))

(define (exponent b i) (coordinate (power-exponent b) i))

;; The number in a radicand whose polynomials are primitive.
(define (number-part v)
  (define p (fraction-numerator v))
  (define c (poly-content p))
  (if (negative? (poly-leading-coefficient p)) (- c) c))
