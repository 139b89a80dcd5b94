#lang racket/base
;; The field of an expression's kernels, made relation after relation.
;;
;; Circles need nothing but their own kernels.  Of a root and an absolute value the relation
;; holds the value of an expression in kernels known before: so inner ones come first.

(require (only-in "work-bounds.rkt" fuel-meter) "field.rkt" "expression-value.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/simplifier.rkt"
         "../kernel/circle.rkt" "../kernel/find-kernels.rkt" "../kernel/kernel.rkt"
         "../kernel/roots.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt")

(provide make-field)

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

;; Roots and absolute values, inner ones first, then in the order of kernels.
(define (sort-tower tower)
  (define (kernel r) (if (root? r) (root-kernel r) r))
  (define (before? a b)
    (define d (- (nesting (kernel-expression (kernel a))) (nesting (kernel-expression (kernel b)))))
    (or (< d 0)
        (and (eqv? d 0) (< (kernel-rank (kernel a)) (kernel-rank (kernel b))))))
  (sort tower before?))

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
             #:when (and (root? (relation-root F r)) (> (relation-degree r) 1)))
    r))

(define (relation-root F r)
  (kernel-relation (field-kernel F (relation-index r))))

;; The radicand; the relation may be of a lower power of it.
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
  (define e (modulus-argument (kernel-relation k)))
  (define u (field-fraction F e))
  (define square (within-bounds F (lambda () e) (lambda () (field-power F u 2))))
  (relation (kernel-index k) 2 (reduce-fraction F square)))

(define (circle-relations R kernels)
  (define one (poly-constant R 1))
  (for/list ([k (in-vector kernels)] #:when (circle? (kernel-relation k)))
    (define o (kernel-relation k))
    (define cosine² (poly-variable R (kernel-index (circle-cosine o)) 2))
    (define sine² (if (eqv? (circle-sign o) 1) (poly- R one cosine²) (poly- R cosine² one)))
    (relation (kernel-index k) 2 (fraction-from-poly R sine²))))
