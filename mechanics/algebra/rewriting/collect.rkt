#lang racket/base
;; Collecting: a value as a polynomial in some of its kernels.
;;
;; The numerator of the normal form is grouped by the monomials in the chosen
;; kernels.  A divisor free of them belongs to the coefficients, a power of one
;; of them lowers its exponents; any other divisor keeps the value from being a
;; polynomial, and is left below the whole, collected like the numerator.

(require racket/list
         "together.rkt"
         (only-in "../assumption/assumption-set.rkt" no-assumptions)
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../field/field.rkt"
         "../kernel/kernel.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt"
         "../presentation/form.rkt" "../presentation/present.rkt" "../presentation/term.rkt"
         "../simplify/simplify-expression.rkt")

(provide collect-expression expression-coefficient find-kernels)

;; chosen : symbols or literal functions applied -> expression and assumptions
(define (collect-expression e chosen [A no-assumptions])
  (define-values (F f assumptions) (normal-form e A))
  (define variables (find-kernels F chosen A))
  (define-values (table divisors) (collected F f variables))
  (define whole (polynomial-expression F table variables))
  (values (if (null? divisors)
              whole
              (make-node op:/ (list whole (divisor-product F divisors variables))))
          assumptions))

;; -> the coefficient of chosen^n as an expression, #f if e is no polynomial in
;; it, and assumptions
(define (expression-coefficient e chosen n [A no-assumptions])
  (define-values (F f assumptions) (normal-form e A))
  (define variables (find-kernels F (list chosen) A))
  (define-values (table divisors) (collected F f variables))
  (define entry (if (null? variables)
                    (and (eqv? n 0) (pair? table) (car table))
                    (assoc (list n) table)))
  (values (cond [(pair? divisors) #f]
                [entry (present F (cdr entry))]
                [else 0])
          assumptions))

;; The indices of those of the expressions that are kernels of the field.
(define (find-kernels F expressions A)
  (for*/list ([e (in-list expressions)]
              [simple (in-value (simplify-expression e A))]
              [k (in-vector (field-kernels F))]
              #:when (equal? (kernel-expression k) simple))
    (kernel-index k)))

;; ---------------------------------------------------------------------------
;; Grouping

;; -> ((exponents . coefficient) ...), the highest first, and the divisors that
;; are left; exponents by variable, coefficients as fractions.
(define (collected F f variables)
  (define R (field-ring F))
  (define-values (free powers mixed) (sort-divisors R f variables))
  (define below (fraction-product R free))
  (define table
    (for/list ([entry (in-list (group-by-exponents R (fraction-numerator f) variables))])
      (cons (map - (car entry) powers)
            (fraction/ R (fraction-from-poly R (cdr entry)) below))))
  (values (sort table higher? #:key car) mixed))

;; The divisors of f free of the variables, the exponent each variable has below,
;; and the other divisors.
(define (sort-divisors R f variables)
  (for/fold ([free '()] [powers (map (lambda (i) 0) variables)] [mixed '()])
            ([h (in-list (fraction-denominator-factors f))])
    (define p (power-base h))
    (define own (poly-variables R p))
    (define (power-of i)
      (if (equal? own (list i)) (* (power-exponent h) (poly-degree R p i)) 0))
    (cond [(not (for/or ([i (in-list variables)]) (memv i own)))
           (values (cons h free) powers mixed)]
          [(and (null? (cdr own)) (eqv? 1 (poly-term-count p)))
           (values free (map + powers (map power-of variables)) mixed)]
          [else (values free powers (cons h mixed))])))

;; ((exponents . polynomial free of the variables) ...)
(define (group-by-exponents R p variables)
  (if (null? variables)
      (list (cons '() p))
      (for*/list ([outer (in-list (poly-coefficients R p (car variables)))]
                  [inner (in-list (group-by-exponents R (slice-coefficient outer)
                                                      (cdr variables)))])
        (cons (cons (slice-degree outer) (car inner)) (cdr inner)))))

;; By degree, then by the first variables.
(define (higher? as bs)
  (define m (apply + as))
  (define n (apply + bs))
  (if (eqv? m n)
      (let loop ([as as] [bs bs])
        (cond [(null? as) #f]
              [(eqv? (car as) (car bs)) (loop (cdr as) (cdr bs))]
              [else (> (car as) (car bs))]))
      (> m n)))

;; ---------------------------------------------------------------------------
;; Writing

(define (polynomial-expression F table variables)
  (form-expression
   (sum-form (for/list ([entry (in-list table)] #:unless (fraction-zero? (cdr entry)))
               (term-form* F (cdr entry) (car entry) variables)))))

;; A coefficient times powers.  A sum stands as it is presented by itself; any other is written as
;; part of the term.
(define (term-form* F coefficient exponents variables)
  (define R (field-ring F))
  (define e (present F coefficient))
  (define powers
    (for/list ([i (in-list variables)] [n (in-list exponents)] #:unless (eqv? n 0))
      (cons (field-kernel F i) n)))
  (define monomial
    (fraction-product R
      (for/list ([i (in-list variables)] [n (in-list exponents)])
        (make-power (poly-variable R i) n))))
  (cond [(null? powers) (expression->form e)]
        [(sum? e) (expression->form (times e powers))]
        [else (expression->form (present F (fraction* R coefficient monomial)))]))

;; A sum times powers
(define (times e powers)
  (define (product factors) (flatten-products (make-node op:* factors)))
  (define-values (symbols others)
    (partition (lambda (p) (symbol? (kernel-expression (car p)))) (positive-powers powers)))
  (define above
    (product (append (power-expressions symbols) (list e) (power-expressions others))))
  (define below (power-expressions (negative-powers powers)))
  (if (null? below)
      above
      (make-node op:/ (list above (product below)))))

(define (power-expressions powers)
  (for/list ([p (in-list (by-rank powers))])
    (form-expression (product-form 1 (list p) '() '() #f))))

(define (divisor-product F divisors variables)
  (flatten-products
   (make-node op:*
              (for/list ([h (in-list divisors)])
                (define-values (table none)
                  (collected F (fraction-from-poly (field-ring F) (car h)) variables))
                (e:expt (polynomial-expression F table variables) (cdr h))))))
