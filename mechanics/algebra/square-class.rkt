#lang racket/base
;; Square roots that are products of others: √6 = √2 √3, √(xy) = √x √y.
;;
;; Radicands are written over a coprime basis of polynomials, their numbers over
;; primes and -1.  Modulo squares a radicand is the vector of the parities of its
;; exponents, and its root depends on other roots just when its vector is a sum
;; of theirs over GF(2).  Then u = w² ∏ uᵢ, and √u = w ∏ √uᵢ if no element of
;; the basis is negative, which has to be assumed.

(require "lattice.rkt" "polynomial/polynomial.rkt" "polynomial/fraction.rkt"
         "polynomial/coprime-basis.rkt")

(provide square-dependence)

;; u, us : fractions, not zero -> members w basis: the positions in us of the uᵢ,
;; the fraction w, and the polynomials of the basis that occur; or #f #f #f.
(define (square-dependence R u us)
  (define all (cons u us))
  (define basis
    (for/fold ([basis '()]) ([v (in-list all)] [i (in-naturals)]) (insert R basis v i)))
  (define numbers (map number-part all))
  (define primes (distinct (apply append (map prime-factors numbers))))
  (define masks
    (for/list ([v (in-list all)] [c (in-list numbers)] [i (in-naturals)])
      (parity-mask basis primes c i)))
  (define members (express (car masks) (cdr masks)))
  (if members
      (values members
              (quotient-root R basis numbers (map add1 members))
              (for/list ([b (in-list basis)] #:when (assv 0 (cdr b))) (car b)))
      (values #f #f #f)))

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

;; Small primes in numerator and denominator, and what is left of each.
(define (prime-factors c)
  (append (integer-factors (abs (numerator c)))
          (integer-factors (denominator c))))

(define (integer-factors n)
  (let loop ([n n] [p 2])
    (cond [(eqv? n 1) '()]
          [(or (> p 1000) (> (* p p) n)) (list n)]
          [(zero? (remainder n p)) (cons p (loop (quotient n p) p))]
          [else (loop n (+ p 1))])))

(define (distinct xs)
  (for/fold ([kept '()] #:result (reverse kept)) ([x (in-list xs)])
    (if (memv x kept) kept (cons x kept))))

;; ---------------------------------------------------------------------------
;; Parities

(define (parity-mask basis primes c i)
  (define own (prime-factors c))
  (define bits
    (append (list (negative? c))
            (for/list ([p (in-list primes)])
              (odd? (for/sum ([q (in-list own)] #:when (eqv? p q)) 1)))
            (for/list ([b (in-list basis)]) (odd? (exponent b i)))))
  (for/fold ([mask 0]) ([bit (in-list bits)]) (+ (* 2 mask) (if bit 1 0))))

;; The positions of the masks whose sum modulo 2 is the target, or #f.
(define (express target masks)
  (define pivots
    (for/fold ([pivots '()]) ([m (in-list masks)] [i (in-naturals)])
      (define-values (rest members) (reduce m (list i) pivots))
      (if (eqv? rest 0) pivots (cons (cons rest members) pivots))))
  (define-values (rest members) (reduce target '() pivots))
  (and (eqv? rest 0) members))

;; Pivots are (mask . members); each clears its highest bit.
(define (reduce mask members pivots)
  (define pivot
    (for/first ([p (in-list (sort pivots > #:key car))]
                #:when (bitwise-bit-set? mask (- (integer-length (car p)) 1)))
      p))
  (if (and pivot (not (eqv? mask 0)))
      (reduce (bitwise-xor mask (car pivot))
              (symmetric-difference members (cdr pivot))
              pivots)
      (values mask members)))

(define (symmetric-difference as bs)
  (append (filter (lambda (a) (not (memv a bs))) as)
          (filter (lambda (b) (not (memv b as))) bs)))

;; ---------------------------------------------------------------------------

;; w with u₀ = w² ∏ uᵢ over the members.
(define (quotient-root R basis numbers members)
  (define (total f) (- (f 0) (for/sum ([i (in-list members)]) (f i))))
  (define c
    (/ (car numbers) (for/product ([i (in-list members)]) (list-ref numbers i))))
  (define negatives (total (lambda (i) (if (negative? (list-ref numbers i)) 1 0))))
  (define root (/ (integer-sqrt (numerator c)) (integer-sqrt (denominator c))))
  (define signed-root (if (eqv? 0 (modulo negatives 4)) root (- root)))
  (for/fold ([w (fraction-from-poly R (poly-constant R signed-root))])
            ([b (in-list basis)])
    (fraction* R w
               (fraction-expt R (fraction-from-poly R (car b))
                              (quotient (total (lambda (i) (exponent b i))) 2)))))
