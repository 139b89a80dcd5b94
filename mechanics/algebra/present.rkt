#lang racket/base
;; From the canonical value back to what a physicist would write.
;;
;; The value is a reduced fraction of polynomials in kernels.  Presentation
;; chooses among equal forms of it, and never changes the value:
;;
;; - a sum is written expanded, or with its numeric and monomial content in
;;   front when that makes it smaller by a fifth at least;
;; - a fraction is split over the terms of its numerator, or kept as one
;;   quotient, whichever is smaller.
;;
;; Sizes are counted as symbols and numbers read; ties go to the form named
;; first.  The choice depends on the value and the order of kernels alone.

(require "operation.rkt" "expression.rkt" "kernel.rkt" "collect.rkt" "field.rkt" "term.rkt"
         "exact.rkt" "radical-parts.rkt"
         "polynomial/polynomial.rkt" "polynomial/fraction.rkt")

(provide present linear-terms)

(define (present F f)
  (define inexact? (atlas-inexact? (field-atlas F)))
  (define size (make-kernel-size))
  (define numerator (poly->terms F (fraction-numerator f)))
  (define factors (denominator-terms F f))
  (define-values (below others) (split-monomials factors))
  (define split (split-terms F (fraction-numerator f) below))
  (cond [(null? numerator) 0]
        [(null? factors) (present-sum numerator inexact? size)]
        [(null? others)
         (smaller (present-sum split inexact? size)
                  (present-quotient numerator factors inexact? size))]
        [else (present-quotient numerator factors inexact? size)]))

;; The value as a linear combination: ((rational . expression) ...), in the
;; order of its terms.
(define (linear-terms F f)
  (define-values (below others) (split-monomials (denominator-terms F f)))
  (define divisor
    (and (pair? others)
         (product-expression 1 (factor-expressions others #f))))
  (for/list ([t (in-list (split-terms F (fraction-numerator f) below))])
    (define monomial (terms->expression (list (term 1 (term-powers t))) #f))
    (cons (term-coefficient t)
          (if divisor (make-node op:/ (list monomial divisor)) monomial))))

;; The terms of a polynomial times powers of kernels, what cancels cancelled.
(define (split-terms F p below)
  (term-sort
   (apply append
          (for/list ([part (in-list (radical-parts F p below))])
            (multiply-terms (poly->terms F (car part)) (cdr part))))))

(define (denominator-terms F f)
  (for/list ([h (in-list (fraction-denominator-factors f))])
    (cons (poly->terms F (car h)) (cdr h))))

(define (smaller a b)
  (if (<= (expression-size a) (expression-size b)) a b))

(define (make-kernel-size)
  (define memo (make-memo))
  (lambda (k) (memo k (lambda () (expression-size (kernel-expression k))))))

;; ---------------------------------------------------------------------------
;; Terms

(define (poly->terms F p)
  (define kernels (field-kernels F))
  (term-sort
   (for/list ([t (in-list (poly-terms (field-ring F) p))])
     (term (car t)
           (for/list ([f (in-list (cdr t))])
             (cons (vector-ref kernels (car f)) (cdr f)))))))

;; The single-term factors of a denominator as powers with negative exponents,
;; and the others.
(define (split-monomials factors)
  (for/fold ([below '()] [others '()] #:result (values below (reverse others)))
            ([f (in-list factors)])
    (define terms (car f))
    (if (null? (cdr terms))
        (values (multiply-powers below (scale-powers (term-powers (car terms)) (- (cdr f))))
                others)
        (values below (cons f others)))))

(define (scale-powers powers k)
  (for/list ([p (in-list powers)]) (cons (car p) (* k (cdr p)))))

(define (multiply-powers as bs)
  (cond [(null? as) bs]
        [(null? bs) as]
        [else
         (define i (kernel-index (caar as)))
         (define j (kernel-index (caar bs)))
         (cond [(< i j) (cons (car as) (multiply-powers (cdr as) bs))]
               [(> i j) (cons (car bs) (multiply-powers as (cdr bs)))]
               [else
                (define e (+ (cdar as) (cdar bs)))
                (define rest (multiply-powers (cdr as) (cdr bs)))
                (if (eqv? e 0) rest (cons (cons (caar as) e) rest))])]))

(define (multiply-terms terms powers)
  (for/list ([t (in-list terms)])
    (term (term-coefficient t) (multiply-powers (term-powers t) powers))))

;; ---------------------------------------------------------------------------
;; Sums

(define (present-sum terms inexact? size)
  (define-values (c powers core) (extract-content terms))
  (cond [(null? (cdr terms)) (terms->expression terms inexact?)]
        [(and (eqv? c 1) (null? powers)) (terms->expression terms inexact?)]
        [(factored-better? c powers core terms size)
         (product-of (term c powers) core inexact?)]
        [else (terms->expression terms inexact?)]))

;; Does factoring save a fifth?
(define (factored-better? c powers core terms size)
  (define whole (terms-size terms size))
  (define factored
    (+ 1 (if (eqv? c 1) 0 1)
       (for/sum ([p (in-list powers)]) (+ (size (car p)) (if (eqv? 1 (cdr p)) 0 2)))
       (terms-size core size)))
  (<= (* 5 factored) (* 4 whole)))

;; -> c powers core: terms = c · powers · core, core with coprime integer
;; coefficients, not all negative.
(define (extract-content terms)
  (define c (content (map term-coefficient terms)))
  (define signed
    (if (andmap (lambda (t) (negative? (term-coefficient t))) terms) (- c) c))
  (define powers
    (for/fold ([common (term-powers (car terms))]) ([t (in-list (cdr terms))])
      (common-powers common (term-powers t))))
  (define inverse (scale-powers powers -1))
  (values signed powers
          (for/list ([t (in-list terms)])
            (term (/ (term-coefficient t) signed)
                  (multiply-powers (term-powers t) inverse)))))

(define (content cs)
  (/ (apply gcd (map numerator cs)) (apply lcm (map denominator cs))))

(define (common-powers as bs)
  (cond [(or (null? as) (null? bs)) '()]
        [else
         (define i (kernel-index (caar as)))
         (define j (kernel-index (caar bs)))
         (cond [(< i j) (common-powers (cdr as) bs)]
               [(> i j) (common-powers as (cdr bs))]
               [else (cons (cons (caar as) (min (cdar as) (cdar bs)))
                           (common-powers (cdr as) (cdr bs)))])]))

;; The term times a sum: number, symbols, the sum, other kernels.
(define (product-of t core inexact?)
  (define-values (above below) (term-split t))
  (define sum (terms->expression core inexact?))
  (product-expression (present-number (term-coefficient t) inexact?)
                      (insert-sum sum above)))

(define (insert-sum sum factors)
  (cond [(and (pair? factors) (symbol-power? (car factors)))
         (cons (car factors) (insert-sum sum (cdr factors)))]
        [else (cons sum factors)]))

(define (symbol-power? e)
  (or (symbol? e)
      (and (node? e) (eq? (node-head e) op:expt) (symbol? (car (node-args e))))))

;; ---------------------------------------------------------------------------
;; Quotients

(define (present-quotient numerator factors inexact? size)
  (define-values (c powers core) (extract-content numerator))
  (define whole (if (integer? c) 1 (denominator c)))
  (define above
    (present-sum (scale-terms whole numerator) inexact? size))
  (define below
    (product-expression whole (factor-expressions factors inexact?)))
  (make-node op:/ (list above below)))

(define (factor-expressions factors inexact?)
  (for/list ([f (in-list factors)])
    (define base (terms->expression (car f) inexact?))
    (if (eqv? (cdr f) 1) base (make-node op:expt (list base (cdr f))))))

(define (scale-terms c terms)
  (if (eqv? c 1)
      terms
      (for/list ([t (in-list terms)])
        (term (* c (term-coefficient t)) (term-powers t)))))
