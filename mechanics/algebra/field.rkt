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

(require "kernel.rkt" "collect.rkt" "circle.rkt" "walk.rkt" "bounds.rkt" "polynomial/polynomial.rkt"
         "polynomial/fraction.rkt" "polynomial/ring.rkt")

(provide (struct-out field) (struct-out relation)
         make-field field-fraction field-inexact? field-circle-sum field-doubled? reduce-poly reduce-fraction lower)

;; kernels : vector by index; relations : from the top of the tower;
;; circles : those known by their angles, presentation may add some
(struct field (atlas kernels ring relations circles) #:authentic)

;; xᵢ^degree = radicand, a fraction.
(struct relation (index degree radicand) #:authentic)

(define (field-inexact? F) (atlas-inexact? (field-atlas F)))

;; ---------------------------------------------------------------------------
;; The field and the value of an expression

;; atlas -> field, in a ring of the given greatest degree.
(define (make-field atlas kernels max-degree)
  (define R (make-ring (vector-length kernels) max-degree))
  (define circles (make-circles kernels (atlas-services atlas)))
  (define (over relations) (field atlas kernels R relations circles))
  (for/fold ([F (over (circle-relations R kernels))])
            ([r (in-list (reverse (atlas-roots atlas)))])
    (define i (kernel-index (root-kernel r)))
    (define value (field-fraction F (root-radicand r)))
    (over (cons (relation i (root-degree r) value) (field-relations F)))))

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
  (reduce-fraction F (evaluate-in (fraction-arithmetic F) (field-atlas F) e)))

(define (fraction-arithmetic F)
  (define R (field-ring F))
  (define (divisor f)
    (define g (reduce-fraction F f))
    (when (fraction-zero? g) (raise-obstacle))
    g)
  (arithmetic
   (lambda (c) (fraction-from-poly R (poly-constant R c)))
   (lambda (k) (fraction-from-poly R (poly-variable R (kernel-index k))))
   (lambda (fs) (check-addition fs) (fraction-sum R fs))
   (lambda (fs)
     (for/fold ([p (car fs)]) ([f (in-list (cdr fs))])
       (check-multiplication p f)
       (fraction* R p f)))
   (lambda (f g) (check-addition (list f g)) (fraction- R f g))
   (lambda (f g)
     (define d (divisor g))
     (check-multiplication f d)
     (fraction/ R f d))
   (lambda (f k)
     (define base (if (negative? k) (divisor f) f))
     (check-expansion base (abs k))
     (fraction-expt R base k))))

;; ---------------------------------------------------------------------------
;; Reduction

(define (reduce-fraction F f)
  (for/fold ([f f]) ([r (in-list (field-relations F))])
    (reduce-by (field-ring F) r f)))

;; The value of a polynomial with every relation applied.
(define (reduce-poly F p)
  (reduce-fraction F (fraction-from-poly (field-ring F) p)))

(define (reduce-by R r f)
  (define p (fraction-numerator f))
  (define factors (fraction-denominator-factors f))
  (define (high? p) (reaches? R p (relation-index r) (relation-degree r)))
  (cond [(or (high? p) (ormap (lambda (h) (high? (car h))) factors))
         (for/fold ([value (lower R r p)]) ([h (in-list factors)])
           (fraction/ R value (lower-power R r (car h) (cdr h))))]
        [else f]))

;; Does the variable occur in p to this power?
(define (reaches? R p i degree)
  (for/or ([t (in-list p)]) (>= (monomial-exponent R (car t) i) degree)))

(define (lower-power R r p e)
  (fraction-expt R (lower R r p) e))

;; p as a fraction in which variable i stays below the relation's degree.
(define (lower R r p)
  (define i (relation-index r))
  (define q (relation-degree r))
  (define groups (make-hasheqv))
  (for ([entry (in-list (poly-coefficients R p i))])
    (hash-update! groups (quotient (car entry) q)
                  (lambda (part) (cons (cons (remainder (car entry) q) (cdr entry)) part))
                  '()))
  (fraction-sum R
    (for/list ([j (in-list (sort (hash-keys groups) <))])
      (fraction* R
                 (fraction-from-poly R (poly-from-coefficients R i (hash-ref groups j)))
                 (fraction-expt R (relation-radicand r) j)))))

;; ---------------------------------------------------------------------------
;; Angles

;; The circle of the sum (sign 1) or difference of two angles, and 1 or, if it
;; is that of the opposite, -1.
(define (field-circle-sum F a b sign)
  (combine-circles! (field-circles F) a b sign))

(define (field-doubled? F o)
  (and (memq o (atlas-doubled (field-atlas F))) #t))
