#lang racket/base
;; p = 0 as the equation that is read most easily.
;;
;; p is a polynomial over a field of kernels.  It is solved for a symbol, or a power of one;
;; or it is a difference of two terms, which are equal then.

(require racket/list
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/size.rkt" "../expression/symbols.rkt"
         "../field/field.rkt"
         "../kernel/kernel.rkt"
         "../polynomial/factor.rkt" "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt"
         "../presentation/present.rkt")

(provide relation-for moving-coefficients irreducible kernel-at all-kernels?
         constant-expression?)

;; Is it made of symbols that are no variables?
(define (constant-expression? e variables)
  (node-fold e
             (lambda (leaf) (not (memq leaf variables)))
             (lambda (n constant?s) (and (operation? (node-head n)) (andmap values constant?s)))))

(define (kernel-at F i) (kernel-expression (field-kernel F i)))

(define (all-kernels? F p kind?)
  (for/and ([i (in-list (poly-variables (field-ring F) p))]) (kind? (kernel-at F i))))

;; p = 0 as the equation that is read most easily, or #f.
(define (relation-for F p)
  (define open (open-symbols F p))
  (define (solve simple? powers) (for/or ([i (in-list open)]) (solve-for F p i simple? powers)))
  (define (first-power? n) (eqv? n 1))
  (define (higher-power? n) (> n 1))
  (or (solve poly-constant? first-power?)
      (and (pair? open)
           (all-kernels? F p symbol?)
           (or (two-sides F p)
               (solve monomial? first-power?)
               (and (mixed-signs? F p) (solve monomial? higher-power?))
               (solve short? first-power?)))
      (solve monomial? first-power?)))

(define (monomial? p) (eqv? (poly-term-count p) 1))
(define (short? p) (<= (poly-term-count p) 4))

(define (mixed-signs? F p)
  (define coefficients (map poly-term-coefficient (poly-terms (field-ring F) p)))
  (and (ormap positive? coefficients) (ormap negative? coefficients)))

;; Kernels of p that are symbols standing in no other kernel of it.
(define (open-symbols F p)
  (define is (poly-variables (field-ring F) p))
  (define (elsewhere? s)
    (for/or ([i (in-list is)])
      (define e (kernel-at F i))
      (and (node? e) (not (constant-expression? e (list s))))))
  (for/list ([i (in-list is)]
             #:when (and (free-symbol? (kernel-at F i)) (not (elsewhere? (kernel-at F i)))))
    i))

;; p solved for a power of variable i, if no other power of it occurs and its
;; coefficient is simple.
(define (solve-for F p i simple? power?)
  (define R (field-ring F))
  (define slices (poly-coefficients R p i))
  (define n (slice-degree (car slices)))
  (define c (slice-coefficient (car slices)))
  (define lower (cdr slices))
  (and (power? n)
       (simple? c)
       (or (null? lower) (eqv? (slice-degree (car lower)) 0))
       (let ([rest (if (null? lower) (poly-constant R 0) (slice-coefficient (car lower)))])
         (equation (e:expt (kernel-at F i) n)
                   (present F (fraction/ R
                                         (fraction-from-poly R (poly-negate R rest))
                                         (fraction-from-poly R c)))))))

;; A difference of two terms as an equation between them: the shorter one on the left,
;; a number on the right.
(define (two-sides F p)
  (define R (field-ring F))
  (define terms (poly-terms R p))
  (and (mixed-signs? F p)
       (null? (cddr terms))
       (let ([sides (for/list ([t (in-list terms)])
                      (present-poly F (term->poly R (abs (poly-term-coefficient t))
                                                  (poly-term-powers t))))])
         (if (left-before? (car sides) (cadr sides))
             (equation (car sides) (cadr sides))
             (equation (cadr sides) (car sides))))))

(define (left-before? a b)
  (and (not (number? a))
       (or (number? b) (<= (expression-size a) (expression-size b)))))

(define (equation left right) (list '= (expression->datum left) (expression->datum right)))

;; The irreducible factors of p, each once; p itself if it has a single term, or many.
(define (irreducible R p)
  (if (<= 2 (poly-term-count p) most-factored)
      (map power-base (poly-factor R p))
      (list p)))

(define most-factored 60)

;; ---------------------------------------------------------------------------
;; Moving parts

;; The coefficients of p, seen as a polynomial in the kernels that are no parameters,
;; short ones first.
(define (moving-coefficients F p parameter?)
  (define R (field-ring F))
  (define (moving? power) (not (parameter? (kernel-at F (power-base power)))))
  (define (coefficient terms)
    (poly-sum R (for/list ([t (in-list terms)])
                  (term->poly R (poly-term-coefficient t)
                              (filter-not moving? (poly-term-powers t))))))
  (define groups
    (group-by (lambda (t) (filter moving? (poly-term-powers t))) (poly-terms R p)))
  (sort (map coefficient groups)
        < #:key (lambda (c) (+ (* 100 (poly-term-count c)) (poly-total-degree R c)))))

(define (term->poly R c powers)
  (for/fold ([p (poly-constant R c)]) ([f (in-list powers)])
    (poly* R p (poly-expt R (poly-variable R (power-base f)) (power-exponent f)))))
