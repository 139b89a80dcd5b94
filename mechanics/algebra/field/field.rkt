#lang racket/base
;; Expressions as fractions of polynomials in their kernels, modulo relations.
;;
;; The kernels of an expression generate a field: rational functions in those
;; that are independent, extended by sines (sin² = 1 - cos²) and roots
;; (rᵠ = u).  An element is a fraction of polynomials; it is *reduced* when no
;; sine occurs squared and no root to its degree, above or below.  The
;; numerator of a reduced fraction is zero just when the element is: that is
;; the ground of a proof of identity.
;;
;; Relations form a tower, each over the kernels of those before it; reducing
;; from the top once suffices.

(require "work-bounds.rkt"
         "../assumption/ledger.rkt"
         "../expression/short-list.rkt" "../expression/simplifier.rkt"
         "../kernel/circle.rkt" "../kernel/find-kernels.rkt" "../kernel/kernel.rkt"
         "../polynomial/fraction.rkt" "../polynomial/monomial.rkt" "../polynomial/polynomial.rkt"
         "../polynomial/ring.rkt" "../polynomial/term-list.rkt")

(provide (struct-out field) (struct-out relation)
         field-inexact? field-simplifier field-fuel
         field-kernel kernel-powers summands relation-of
         wider-field with-room degree-limit
         field-variable field-sum field-product field-difference field-quotient field-power
         field-combined-circle field-doubled? field-whole-kernel field-not-negative?
         reduce-poly reduce-fraction lower)

;; kernels : vector by index; relations : from the top of the tower;
;; circles : those known by their angles, presentation may add some;
;; branch : field polynomial -> 1 or -1, as its sign is known or taken to be, or #f
(struct field (atlas kernels ring relations circles branch) #:authentic)

;; xᵢ^degree = radicand, a fraction.
(struct relation (index degree radicand) #:authentic)

(define (field-inexact? F) (atlas-inexact? (field-atlas F)))
(define (field-simplifier F) (atlas-simplifier (field-atlas F)))
(define (field-fuel F) (simplifier-fuel (field-simplifier F)))

;; Is e known not to be negative, or taken to be so from now on?
(define (field-not-negative? F e) (taken-not-negative? (field-simplifier F) e))

;; ---------------------------------------------------------------------------
;; Variables of the ring as kernels

(define (field-kernel F i) (vector-ref (field-kernels F) i))

;; Powers of variables as powers of their kernels.
(define (kernel-powers F powers)
  (for/list ([p (in-list powers)])
    (make-power (field-kernel F (power-base p)) (power-exponent p))))

;; The terms of the polynomial p: ((coefficient . powers of kernels) ...)
(define (summands F p)
  (for/list ([t (in-list (poly-terms (field-ring F) p))])
    (cons (poly-term-coefficient t) (kernel-powers F (poly-term-powers t)))))

;; The relation of variable i, or #f.
(define (relation-of F i)
  (findf (lambda (r) (eqv? i (relation-index r))) (field-relations F)))

;; ---------------------------------------------------------------------------
;; Rings of other degrees

;; -> the field and the fraction in a ring of a greater degree
(define (wider-field F f max-degree)
  (define R (field-ring F))
  (define W (wider-ring R max-degree))
  (define (wider g) (fraction-rering R W g))
  (values (field (field-atlas F) (field-kernels F) W
                 (for/list ([r (in-list (field-relations F))])
                   (relation (relation-index r) (relation-degree r) (wider (relation-radicand r))))
                 (field-circles F)
                 (field-branch F))
          (wider f)))

;; (proceed F f), in wider rings until there is room for its degrees.
(define (with-room F f proceed)
  (define result
    (with-handlers ([exn:algebra:degree-overflow? values]) (proceed F f)))
  (cond [(exn:algebra:degree-overflow? result)
         (define-values (W w) (wider-field F f (+ 1 (* 2 (ring-max-degree (field-ring F))))))
         (with-room W w proceed)]
        [else result]))

;; A ring for polynomials of a higher degree than this is not made for an expression.
(define degree-limit 1000000)

;; ---------------------------------------------------------------------------
;; Reduction

(define (reduce-fraction F f)
  (if (and (fraction-polynomial? f) (low? F (fraction-numerator f)))
      f
      (for/fold ([f f]) ([r (in-list (field-relations F))])
        (reduce-by (field-ring F) r f))))

;; Does a quick look show that no relation applies?  The bits of all exponents
;; of a variable together are at least its greatest exponent.
(define (low? F p)
  (or (null? p)
      (null? (field-relations F))
      (let ([R (field-ring F)]
            [bits (for/fold ([bits (leading-monomial p)]) ([t (in-list (cdr p))])
                    (monomial-join bits (term-monomial t)))])
        (for/and ([r (in-list (field-relations F))])
          (< (monomial-exponent R bits (relation-index r)) (relation-degree r))))))

;; The value of a polynomial with every relation applied.
(define (reduce-poly F p)
  (reduce-fraction F (fraction-from-poly (field-ring F) p)))

(define (reduce-by R r f)
  (define p (fraction-numerator f))
  (define factors (fraction-denominator-factors f))
  (define i (relation-index r))
  (define q (relation-degree r))
  (define (high? h)
    (define p (power-base h))
    (or (reaches? R p i q) (reaches? R p i (/ q (power-exponent h)) #t)))
  (cond [(or (reaches? R p i q) (ormap high? factors))
         (for/fold ([value (lower R r p)]) ([h (in-list factors)])
           (fraction/ R value (lower-power R r (power-base h) (power-exponent h))))]
        [else f]))

;; Does the variable occur in p to this power?  alone? : and nothing else?
(define (reaches? R p i degree [alone? #f])
  (and (or (not alone?) (single-term? p))
       (for/or ([t (in-list p)]) (>= (monomial-exponent R (term-monomial t) i) degree))))

(define (lower-power R r p e)
  (if (single-term? p)
      (lower R r (poly-expt R p e))
      (fraction-expt R (lower R r p) e)))

;; p as a fraction in which variable i stays below the relation's degree.
(define (lower R r p)
  (define i (relation-index r))
  (define q (relation-degree r))
  (define groups (make-hasheqv))
  (for ([s (in-list (poly-coefficients R p i))])
    (define low (make-slice (remainder (slice-degree s) q) (slice-coefficient s)))
    (hash-update! groups (quotient (slice-degree s) q)
                  (lambda (part) (cons low part))
                  '()))
  (fraction-sum R
    (for/list ([j (in-list (sort (hash-keys groups) <))])
      (fraction* R
                 (fraction-from-poly R (poly-from-coefficients R i (hash-ref groups j)))
                 (fraction-expt R (relation-radicand r) j)))))

;; ---------------------------------------------------------------------------
;; Operations

;; Each is a step of the walk (expression-value.rkt), which may cost so much and no more.

(define (field-variable F k)
  (fraction-from-poly (field-ring F) (poly-variable (field-ring F) (kernel-index k))))

(define (field-sum F . fs)
  (begin-step! (field-fuel F))
  (check-sum (field-fuel F) fs)
  (fraction-sum (field-ring F) fs))

(define (field-product F p . fs)
  (begin-step! (field-fuel F))
  (for/fold ([p p]) ([f (in-list fs)])
    (reduce-if-worthwhile F (fraction* (field-ring F) p f))))

(define (field-difference F f g)
  (begin-step! (field-fuel F))
  (check-sum (field-fuel F) (list f g))
  (fraction- (field-ring F) f g))

(define (field-quotient F f g)
  (begin-step! (field-fuel F))
  (reduce-fraction F (fraction/ (field-ring F) f (divisor F g))))

(define (field-power F f k)
  (begin-step! (field-fuel F))
  (define base (if (negative? k) (divisor F f) f))
  (check-expansion (field-fuel F) base (abs k))
  (reduce-if-worthwhile F (fraction-expt (field-ring F) base k)))

;; f reduced, which must not be zero
(define (divisor F f)
  (define g (reduce-fraction F f))
  (when (fraction-zero? g) (raise-obstacle))
  g)

;; Short polynomials are left for the end: most of their sin² + cos² cancel.
(define (reduce-if-worthwhile F f)
  (if (and (fraction-polynomial? f) (short? (fraction-numerator f) 300))
      f
      (reduce-fraction F f)))

;; ---------------------------------------------------------------------------
;; Angles

;; The circle of a combination ((circle . integer) ...) of angles, and 1 or, if it
;; is that of the opposite, -1.
(define (field-combined-circle F multiples)
  (combine-circles! (field-circles F) multiples))

;; A kernel that is this expression.
(define (field-whole-kernel F e [relation #f])
  (whole-kernel! (field-circles F) e relation))

(define (field-doubled? F o)
  (and (memq o (atlas-doubled (field-atlas F))) #t))
