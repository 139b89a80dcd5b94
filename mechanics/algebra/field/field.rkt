#lang racket/base
;; Expressions as fractions of polynomials in their kernels, modulo relations.
;;
;; The kernels of an expression generate a field: rational functions in those
;; that are independent, extended by sines (sin² = 1 - cos²) and roots
;; (rᵠ = u).  An element is a fraction of polynomials; it is *reduced* when no
;; sine occurs squared and no root to its degree, above or below.  The
;; numerator of a reduced fraction is zero just when the element is: that is
;; what a proof of identity rests on.
;;
;; Relations form a tower, each over the kernels of those before it; reducing
;; from the top once suffices.

(require "bounds.rkt" "walk.rkt"
         "../assumption/ledger.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/short-list.rkt" "../expression/simplifier.rkt"
         "../kernel/circle.rkt" "../kernel/find-kernels.rkt" "../kernel/kernel.rkt"
         "../kernel/roots.rkt"
         "../polynomial/fraction.rkt" "../polynomial/monomial.rkt" "../polynomial/polynomial.rkt"
         "../polynomial/ring.rkt" "../polynomial/term-list.rkt")

(provide (struct-out field) (struct-out relation)
         make-field field-fraction field-inexact? field-simplifier
         wider-field with-room degree-limit
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

;; Is e known not to be negative, or taken to be so from now on?
(define (field-not-negative? F e) (taken-not-negative? (field-simplifier F) e))

;; ---------------------------------------------------------------------------
;; The field and the value of an expression

;; atlas -> field, in a ring of the given greatest degree.
(define (make-field atlas kernels max-degree branch)
  (define tank (simplifier-fuel (atlas-simplifier atlas)))
  (define R (make-ring (vector-length kernels) max-degree (fuel-meter tank)))
  (define circles (make-circles kernels (atlas-simplifier atlas)))
  (define (over relations) (field atlas kernels R relations circles branch))
  (for/fold ([F (over (circle-relations R kernels))])
            ([r (in-list (sort-tower (atlas-tower atlas)))])
    (over (cons (if (root? r) (root-relation F r) (modulus-relation F r))
                (field-relations F)))))

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

;; Roots and absolute values, inner ones first, then in the order of kernels.
(define (sort-tower tower)
  (define (kernel r) (if (root? r) (root-kernel r) r))
  (define (before? a b)
    (define d (- (nesting (kernel-expression (kernel a))) (nesting (kernel-expression (kernel b)))))
    (or (< d 0)
        (and (eqv? d 0) (< (kernel-rank (kernel a)) (kernel-rank (kernel b))))))
  (if (or (null? tower) (null? (cdr tower))) tower (sort tower before?)))

;; How deep roots and absolute values are nested in e.
(define (nesting e)
  (node-fold e
             (lambda (leaf) 0)
             (lambda (n depths)
               (+ (apply max 0 depths)
                  (if (memq (node-head n) (list op:sqrt op:expt op:abs)) 1 0)))))

(define (root-relation F r)
  (define i (kernel-index (root-kernel r)))
  (define u (field-fraction F (root-radicand r)))
  (define others (independent-roots F))
  (if (or (null? others) (fraction-zero? u))
      (relation i (root-degree r) u)
      (related-root F i u (root-degree r) others)))

;; The relations of the roots known so far, but for those that others make.
(define (independent-roots F)
  (for/list ([r (in-list (field-relations F))]
             #:when (independent-root? F r))
    r))

(define (independent-root? F r)
  (and (root? (relation-root F r)) (> (relation-degree r) 1)))

(define (relation-root F r)
  (kernel-relation (vector-ref (field-kernels F) (relation-index r))))

;; What stands under the root; the relation may be of a lower power of it.
(define (radicand-of F r)
  (define x (relation-root F r))
  (if (eqv? (root-degree x) (relation-degree r))
      (relation-radicand r)
      (field-fraction F (root-radicand x))))

;; The q-th root of u, whose lower power may be w times powers of other roots.
(define (related-root F i u q others)
  (define R (field-ring F))
  (define-values (power members w)
    (root-dependence R u q
                     (for/list ([r (in-list others)]) (radicand-of F r))
                     (for/list ([r (in-list others)]) (root-degree (relation-root F r)))
                     (lambda (p) ((field-branch F) F p))))
  (relation i power
            (for/fold ([product w]) ([m (in-list members)])
              (define other (relation-index (list-ref others (car m))))
              (fraction* R product
                         (fraction-from-poly R (poly-variable R other (cdr m)))))))

(define (modulus-relation F k)
  (define u (field-fraction F (modulus-argument (kernel-relation k))))
  (relation (kernel-index k) 2 (reduce-fraction F (fraction-expt (field-ring F) u 2))))

(define (circle-relations R kernels)
  (define one (poly-constant R 1))
  (for/list ([k (in-vector kernels)] #:when (circle? (kernel-relation k)))
    (define o (kernel-relation k))
    (define cosine² (poly-variable R (kernel-index (circle-cosine o)) 2))
    (define sine² (if (eqv? (circle-sign o) 1) (poly- R one cosine²) (poly- R cosine² one)))
    (relation (kernel-index k) 2 (fraction-from-poly R sine²))))

;; The reduced fraction an expression stands for.  Where it divides by zero, or
;; would grow past the bounds, the walk is `stuck` at a node.
(define (field-fraction F e)
  (define value (evaluate-in (fraction-arithmetic F) (field-atlas F) e))
  (end-steps! (field-fuel F))
  (reduce-fraction F value))

(define (field-fuel F) (simplifier-fuel (field-simplifier F)))

(define (fraction-arithmetic F)
  (define R (field-ring F))
  (arithmetic
   (lambda (c) (fraction-constant R c))
   (lambda (k) (fraction-from-poly R (poly-variable R (kernel-index k))))
   (lambda (fs) (field-sum F fs))
   (lambda (fs) (field-product F fs))
   (lambda (f g) (field-difference F f g))
   (lambda (f g) (field-quotient F f g))
   (lambda (f k) (field-power F f k))))

;; Each is a step of the walk, which may cost so much and no more.
(define (field-sum F fs)
  (begin-step! (field-fuel F))
  (check-sum (field-fuel F) fs)
  (fraction-sum (field-ring F) fs))

(define (field-product F fs)
  (begin-step! (field-fuel F))
  (for/fold ([p (car fs)]) ([f (in-list (cdr fs))])
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
