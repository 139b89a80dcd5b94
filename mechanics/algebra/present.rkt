#lang racket/base
;; From the canonical value back to what a physicist would write.
;;
;; The value is a reduced fraction of polynomials in kernels.  Presentation
;; chooses among equal forms of it, and never changes the value:
;;
;; - sin² or cos², angles contracted or not: whichever makes fewer terms;
;; - a fraction is split over the terms of its numerator, or kept whole;
;; - a sum is written expanded; or with the terms that agree in all kernels but
;;   symbols collected; or with its content in front.
;;
;; The first form named is kept unless another is smaller by a sixth.  The
;; choice depends on the value and the order of kernels alone.

(require "operation.rkt" "expression.rkt" "kernel.rkt" "field.rkt" "term.rkt" "form.rkt"
         "exact.rkt"
         "spelling.rkt" "pieces.rkt"
         "polynomial/polynomial.rkt" "polynomial/fraction.rkt")

(provide present linear-terms)

(define (present F f)
  (cond [(fraction-zero? f) 0]
        [(fraction-polynomial? f)
         (define p (fraction-numerator f))
         (if (poly-constant? p)
             (form-expression (constant-form F (poly-constant-value p)))
             (form-expression (present-pieces F (fraction->pieces F f))))]
        [else
         (define (present-as pieces) (present-pieces F pieces))
         (form-expression
          (smaller-form (shorter-form (present-as (fraction->pieces F f))
                                      (present-as (fraction->pieces/roots F f)))
                        (present-as (list (fraction->piece F f)))))]))

(define (constant-form F c) (term-form (term c '()) (field-inexact? F)))

;; The value as a linear combination: ((number . expression) ...), in the order
;; of its terms.
(define (linear-terms F f)
  (define p (fraction->piece F f))
  (define-values (sign divisors) (piece-divisors F p))
  (for/list ([t (in-list (term-sort (piece-terms F p)))])
    (cons (present-number (* sign (term-coefficient t)) (field-inexact? F))
          (form-expression (product-form 1 (term-powers t) '() divisors #f)))))

;; ---------------------------------------------------------------------------
;; Polynomials as terms

(define (poly->terms F p)
  (for/list ([t (in-list (spell F p))]) (make-term (car t) (cdr t))))

(define (piece-terms F p)
  (define powers (term-powers (make-term 1 (piece-powers p))))
  (multiply-terms (poly->terms F (piece-numerator p)) powers))

;; -> 1 or -1, and the divisors ((form . exponent) ...): the sign, taken from
;; those that would be mostly negative, belongs to the numerator.
(define (piece-divisors F p)
  (for/fold ([sign 1] [divisors '()] #:result (values sign (reverse divisors)))
            ([h (in-list (piece-factors p))])
    (define terms (poly->terms F (car h)))
    (define flip? (mostly-negative? terms))
    (values (if (and flip? (odd? (cdr h))) (- sign) sign)
            (cons (cons (present-terms F (if flip? (scale-terms -1 terms) terms)) (cdr h))
                  divisors))))

(define (mostly-negative? terms)
  (define (negative t) (negative? (term-coefficient t)))
  (define surplus (for/sum ([t (in-list terms)]) (if (negative t) 1 -1)))
  (or (positive? surplus)
      (and (eqv? surplus 0) (negative (car (term-sort terms))))))

;; ---------------------------------------------------------------------------
;; Sums of pieces

;; Pieces without further divisors are one sum of terms.
(define (present-pieces F pieces)
  (define whole (filter (lambda (p) (null? (piece-factors p))) pieces))
  (define others (filter (lambda (p) (pair? (piece-factors p))) pieces))
  (define terms (apply append (map (lambda (p) (piece-terms F p)) whole)))
  (define quotients (map (lambda (p) (quotient-form F p)) others))
  (cond [(null? quotients) (present-terms F terms)]
        [(null? terms) (sum-form quotients)]
        [else (sum-form (append (sorted-forms F terms) quotients))]))

(define (quotient-form F p)
  (define-values (sign divisors) (piece-divisors F p))
  (define-values (c powers core)
    (extract-content (scale-terms sign (piece-terms F p))))
  (product-form c powers (core-forms F core) divisors (field-inexact? F)))

;; No form for a core that is 1.
(define (core-forms F core)
  (if (and (null? (cdr core)) (null? (term-powers (car core))))
      '()
      (list (collected-form F core))))

;; ---------------------------------------------------------------------------
;; Sums of terms

(define (present-terms F terms)
  (define usual (collected-form F terms))
  (cond [(null? (cdr terms)) usual]
        [(ormap (lambda (t) (pair? (negative-powers (term-powers t)))) terms)
         (prefer-factored F (prefer-factored F usual terms #t) terms #f)]
        [else (prefer-factored F usual terms #f)]))

;; The terms with their content in front, if that is enough smaller.
(define (prefer-factored F usual terms shared?)
  (define-values (c powers core) (extract-content terms shared?))
  (if (and (eqv? c 1) (null? powers))
      usual
      (smaller-form usual (product-form c powers (core-forms F core) '() (field-inexact? F)))))

(define (expanded-form F terms) (sum-form (sorted-forms F terms)))

;; A positive constant comes first.
(define (sorted-forms F terms)
  (define sorted (term-sort terms))
  (define constant
    (for/first ([t (in-list sorted)]
                #:when (and (null? (term-powers t)) (positive? (term-coefficient t))))
      t))
  (for/list ([t (in-list (if constant (cons constant (remq constant sorted)) sorted))])
    (term-form t (field-inexact? F))))

;; Terms that agree in everything but symbols are one summand, a product with a
;; sum in the symbols.
(define (collected-form F terms)
  (define expanded (expanded-form F terms))
  (define groups (group-by-kernels (term-sort terms)))
  (if (or (null? (cdr groups)) (andmap (lambda (g) (null? (cdr g))) groups))
      expanded
      (smaller-form expanded (sum-form (map (lambda (g) (group-form F g)) groups)))))

(define (group-form F group)
  (cond [(null? (cdr group)) (term-form (car group) (field-inexact? F))]
        [else
         (define-values (c powers core) (extract-content group))
         (product-form c powers (list (expanded-form F core)) '() (field-inexact? F))]))

;; A list of lists of terms, in the order of their first terms.
(define (group-by-kernels terms)
  (define table (make-hash))
  (define keys
    (for/fold ([keys '()]) ([t (in-list terms)])
      (define key (kernel-part t))
      (define known? (hash-has-key? table key))
      (hash-update! table key (lambda (group) (cons t group)) '())
      (if known? keys (cons key keys))))
  (for/list ([key (in-list (reverse keys))]) (reverse (hash-ref table key))))

(define (kernel-part t)
  (for/list ([p (in-list (term-powers t))] #:unless (symbol? (kernel-expression (car p))))
    (cons (kernel-rank (car p)) (cdr p))))
