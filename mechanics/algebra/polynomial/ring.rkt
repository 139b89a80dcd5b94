#lang racket/base
;; Rings of polynomials, and monomials packed into integers.
;;
;; A monomial x₀^e₀ ··· xₙ₋₁^eₙ₋₁ is one exact integer: the total degree on top,
;; below it one field a variable, x₀ highest.  A field has room for the ring's
;; greatest degree and one more bit, the *guard*, which is 0 in every monomial:
;;
;;     | total degree | 0 e₀ | 0 e₁ | ... | 0 eₙ₋₁ |
;;
;; Then the product of monomials is +, the graded lexicographic order is <, and
;; a divides b just when b - a borrows across no field, that is when all guard
;; bits of b - a are 0.  With few variables all this is fixnum arithmetic; with
;; many the integers grow and nothing else changes.
;;
;; No exponent exceeds the total degree, so a product fits as soon as its total
;; degree does: one comparison of the product of the leading monomials with
;; `ring-limit` guards a whole multiplication.

(provide
 ;; rings
 make-ring ring? ring-size ring-max-degree
 (struct-out exn:algebra:degree-overflow) raise-degree-overflow
 ;; packed monomials
 ring-limit check-monomial
 variable-unit variable-monomial exponents->monomial factors->monomial
 monomial-degree monomial-exponent monomial-part
 monomial-exponents monomial-factors
 monomial-divides? monomial-gcd)

(struct ring (size max-degree bits field degree-shift guards limit units)
  #:authentic)

;; Polynomials in n variables of total degree at most max-degree.
(define (make-ring n max-degree)
  (define bits (+ 1 (integer-length (max 1 max-degree))))
  (define degree-shift (* n bits))
  (define guards
    (for/fold ([mask 0]) ([i (in-range n)])
      (bitwise-ior mask (arithmetic-shift 1 (- (* (+ i 1) bits) 1)))))
  (define units
    (for/vector #:length n ([i (in-range n)])
      (+ (arithmetic-shift 1 degree-shift)
         (arithmetic-shift 1 (* (- n i 1) bits)))))
  (ring n max-degree bits (- (arithmetic-shift 1 bits) 1) degree-shift guards
        (arithmetic-shift (+ max-degree 1) degree-shift)
        units))

;; ---------------------------------------------------------------------------
;; Degree overflow

;; An operation in a ring would give a polynomial of total degree `degree`, more
;; than the ring's `bound`.  Whoever sized the ring catches it, or has a bug.
(struct exn:algebra:degree-overflow exn:fail (degree bound))

(define (raise-degree-overflow R degree)
  (raise (exn:algebra:degree-overflow
          (format "polynomial: the degree would pass the bound of the ring\n  degree: ~a\n  bound: ~a"
                  degree (ring-max-degree R))
          (current-continuation-marks)
          degree (ring-max-degree R))))

;; m, when it is a monomial of the ring.
(define (check-monomial R m)
  (if (< m (ring-limit R))
      m
      (raise-degree-overflow R (monomial-degree R m))))

;; ---------------------------------------------------------------------------
;; Monomials

;; The monomial xᵢ, which may be more than the ring allows.
(define (variable-unit R i) (vector-ref (ring-units R) i))

(define (variable-monomial R i exponent)
  (check-monomial R (* exponent (variable-unit R i))))

;; exponents : a list or a vector, one a variable
(define (exponents->monomial R exponents)
  (check-monomial R
                  (for/fold ([m 0])
                            ([e (if (vector? exponents) (in-vector exponents) (in-list exponents))]
                             [unit (in-vector (ring-units R))])
                    (if (eq? e 0) m (+ m (* e unit))))))

;; factors : ((index . exponent) ...), each index once
(define (factors->monomial R factors)
  (check-monomial R
                  (for/fold ([m 0]) ([f (in-list factors)])
                    (+ m (* (cdr f) (variable-unit R (car f)))))))

(define (monomial-degree R m) (arithmetic-shift m (- (ring-degree-shift R))))

(define (monomial-exponent R m i)
  (define start (* (- (ring-size R) i 1) (ring-bits R)))
  (bitwise-and (arithmetic-shift m (- start)) (ring-field R)))

;; The monomial's own part below its total degree.
(define (monomial-fields R m)
  (define shift (ring-degree-shift R))
  (- m (arithmetic-shift (arithmetic-shift m (- shift)) shift)))

;; A procedure from monomials to their parts in the given variables.
(define (monomial-part R variables)
  (define mask
    (for/fold ([mask 0]) ([i (in-list variables)])
      (bitwise-ior mask (arithmetic-shift (ring-field R)
                                          (* (- (ring-size R) i 1) (ring-bits R))))))
  (lambda (m)
    (define fields (bitwise-and m mask))
    (if (eq? fields 0) 0 (factors->monomial R (monomial-factors R fields)))))

;; The variables that occur: ((index . exponent) ...) by ascending index.  Costs
;; one step a variable occurring, however many the ring has.
(define (monomial-factors R m)
  (define bits (ring-bits R))
  (define last (- (ring-size R) 1))
  (let loop ([rest (monomial-fields R m)])
    (cond [(eq? rest 0) '()]
          [else
           (define k (quotient (- (integer-length rest) 1) bits))
           (define start (* k bits))
           (define e (arithmetic-shift rest (- start)))
           (cons (cons (- last k) e)
                 (loop (- rest (arithmetic-shift e start))))])))

(define (monomial-exponents R m)
  (define v (make-vector (ring-size R) 0))
  (for ([f (in-list (monomial-factors R m))])
    (vector-set! v (car f) (cdr f)))
  v)

(define (monomial-divides? R a b)
  (eq? 0 (bitwise-and (- b a) (ring-guards R))))

(define (monomial-gcd R a b)
  (define units (ring-units R))
  (let loop ([xs (monomial-factors R a)] [ys (monomial-factors R b)] [m 0])
    (cond [(or (null? xs) (null? ys)) m]
          [(< (caar xs) (caar ys)) (loop (cdr xs) ys m)]
          [(> (caar xs) (caar ys)) (loop xs (cdr ys) m)]
          [else
           (define e (min (cdar xs) (cdar ys)))
           (loop (cdr xs) (cdr ys) (+ m (* e (vector-ref units (caar xs)))))])))
