#lang racket/base
;; Matrices of exact numbers and of expressions, made ready for elimination.
;;
;; Rational numbers become integers, row by row.  Expressions become polynomials
;; in all their kernels, again row by row: the entries are fractions of one
;; field, and a row is multiplied by a common denominator.  An entry is zero if
;; its canonical value is, with all relations of the field applied.
;;
;; Polynomials may outgrow memory on the way: products of terms are counted, and
;; beyond a bound the attempt is given up.

(require "bareiss.rkt"
         (only-in "../assumption/ledger.rkt" simplifier-grounds)
         "../expression/exact-numbers.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt"
         "../field/expression-value.rkt" "../field/field.rkt" "../field/field-extension.rkt"
         "../kernel/find-kernels.rkt" "../kernel/kernel.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt"
         "../presentation/present.rkt"
         "../simplify/domain-question.rkt" "../simplify/normalize.rkt"
         "../simplify/simplifier-workspace.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt")

(provide (struct-out coefficients) (struct-out ratio) call-with-coefficients)

;; rows : in the domain
;; unscale : the determinant of `rows` -> that of the matrix, a number or expression;
;;           #f in domains without exact division
;; most-terms : how many terms the determinant of a square matrix may have, at most
;; negate : entry -> entry;  divide : entry entry -> number or expression
;; primitive : list of ratios -> list of numbers or expressions, in the same ratio
;;             as these, without a common divisor
;; assumptions : thunk -> datums such as (>= r 0), taken for granted so far
(struct coefficients
  (domain rows unscale most-terms negate divide primitive assumptions)
  #:authentic)

;; Of two entries, the lower one not zero.
(struct ratio (above below) #:authentic)

;; matrix : vector of rows; use : coefficients -> any, which may be called again
;; A : assumptions
;; -> the value of `use`, or #f if that took too much, or an entry divides by 0
(define (call-with-coefficients matrix A use)
  (cond [(not (exact-numbers? matrix)) (call-with-polynomials matrix A use)]
        [(all-entries? real? matrix) (use (integer-coefficients matrix))]
        [else (use (complex-coefficients matrix))]))

;; ---------------------------------------------------------------------------
;; Numbers

(define (integer-coefficients matrix)
  (define scales
    (for/list ([row (in-vector matrix)]) (apply lcm (map denominator (vector->list row)))))
  (coefficients integer-domain
                (for/vector #:length (vector-length matrix)
                            ([row (in-vector matrix)] [s (in-list scales)])
                  (for/vector #:length (vector-length row) ([x (in-vector row)]) (* s x)))
                (lambda (d) (/ d (apply * scales)))
                1 - /
                primitive-numbers
                (lambda () '())))

(define (complex-coefficients matrix)
  (coefficients number-domain matrix values 1 - /
                (lambda (ratios) (map ratio-number ratios))
                (lambda () '())))

(define (primitive-numbers ratios)
  (define xs (map ratio-number ratios))
  (define size (rational-content xs))
  (for/list ([x (in-list xs)]) (/ x size)))

(define (ratio-number r) (/ (ratio-above r) (ratio-below r)))

;; ---------------------------------------------------------------------------
;; Expressions

(define (call-with-polynomials matrix A use)
  (define entries (for*/list ([row (in-vector matrix)] [e (in-vector row)]) e))
  (define w (make-workspace A (question-about entries A)))
  (define atlas (collect-kernels (make-node op:+ entries) w))
  (define kernels (place-kernels! (atlas-kernels atlas)))
  (let retry ([degree 15])
    (define result
      (with-handlers ([exn:algebra:degree-overflow? values]
                      [obstruction? (lambda (o) #f)]
                      [outgrown? (lambda (o) #f)])
        (use (field-coefficients (make-field atlas kernels degree poly-branch) matrix w))))
    (if (exn:algebra:degree-overflow? result) (retry (+ 1 (* 2 degree))) result)))

(define (field-coefficients F matrix w)
  (define R (field-ring F))
  (define fractions (rows-map (lambda (e) (field-fraction F e)) matrix))
  (define D
    (if (null? (field-relations F))
        (polynomial-domain R (lambda (p q) (poly-divide R p q)) #f)
        (polynomial-domain R (lambda (p q) (reduce-poly F p)) (lambda (fs) (tidy-row F fs)))))
  (define rows (for/vector ([row (in-vector fractions)]) (tidy-row F row)))
  (coefficients D rows
                (and (not (domain-tidy D))
                     (let ([s (scale R rows fractions)])
                       (lambda (d) (present F (fraction/ R (fraction-from-poly R d) s)))))
                (term-bound R rows)
                (lambda (p) (poly-negate R p))
                (lambda (p q) (present F (ratio-fraction F (ratio p q))))
                (lambda (ratios) (primitive-ratios F ratios))
                (lambda () (simplifier-grounds w))))

(define (ratio-fraction F r)
  (define R (field-ring F))
  (reduce-fraction F (fraction/ R
                                (fraction-from-poly R (ratio-above r))
                                (fraction-from-poly R (ratio-below r)))))

;; The product of the multipliers of the rows: a fraction.
(define (scale R rows fractions)
  (for/fold ([s (fraction-constant R 1)])
            ([row (in-vector rows)] [fs (in-vector fractions)])
    (define factor
      (for/first ([p (in-vector row)] [f (in-vector fs)] #:unless (poly-zero? p))
        (fraction/ R (fraction-from-poly R p) f)))
    (if factor (fraction* R s factor) s)))

;; A polynomial of degree d in k variables has at most (d + k choose k) terms.
(define (term-bound R rows)
  (define degree
    (for/sum ([row (in-vector rows)])
      (for/fold ([d 0]) ([p (in-vector row)]) (max d (poly-total-degree R p)))))
  (for/fold ([terms 1]) ([i (in-range 1 (add1 (ring-size R)))])
    (/ (* terms (+ degree i)) i)))

;; ---------------------------------------------------------------------------
;; Rows of fractions

;; Reduced polynomials with integer coefficients and without a common divisor,
;; in the same ratio as the fractions.
(define (tidy-row F fs)
  (define R (field-ring F))
  (define d (common-denominator R fs))
  (cond [(not (and (poly-constant? d) (eqv? 1 (poly-constant-value d))))
         (tidy-row F (for/vector #:length (vector-length fs) ([f (in-vector fs)])
                       (reduce-fraction F (fraction* R f (fraction-from-poly R d)))))]
        [else
         (define ps (map fraction-numerator (vector->list fs)))
         (define g (poly-gcd* R ps))
         (for/vector #:length (vector-length fs) ([p (in-list ps)])
           (if (poly-zero? p) p (poly-divide R p g)))]))

;; A polynomial with integer coefficients that makes polynomials with integer
;; coefficients of all the fractions.
(define (common-denominator R fs)
  (define d
    (for/fold ([d (poly-constant R 1)]) ([f (in-vector fs)])
      (define rest (fraction* R f (fraction-from-poly R d)))
      (poly* R d (fraction-denominator R rest))))
  (define numbers
    (for/fold ([n 1]) ([f (in-vector fs)])
      (define p (fraction-numerator (fraction* R f (fraction-from-poly R d))))
      (lcm n (denominator (poly-content p)))))
  (poly-scale R numbers d))

;; The fractions are in lowest terms, so their numerators over the common
;; denominator do not depend on a factor that above and below shared.
(define (primitive-ratios F ratios)
  (define fs (for/vector ([r (in-list ratios)]) (ratio-fraction F r)))
  (for/list ([p (in-vector (tidy-row F fs))])
    (present-poly F p)))

;; ---------------------------------------------------------------------------
;; Polynomials as domains

(struct outgrown ())

;; How many products of terms an elimination may take: a few seconds' worth.
(define work-limit 20000000)

;; -> multiplication that counts
(define (make-product R)
  (define left work-limit)
  (lambda (p q)
    (set! left (- left (* (poly-term-count p) (poly-term-count q))))
    (when (< left 0) (raise (outgrown)))
    (poly* R p q)))

;; finish : polynomial and the pivot before -> entry
(define (polynomial-domain R finish tidy)
  (define product (make-product R))
  (domain '() (poly-constant R 1) poly-zero? poly-term-count
          (lambda (a b c d q) (finish (poly- R (product a b) (product c d)) q))
          tidy))
