#lang racket/base
;; Terms: a number times powers of kernels, in the order they are written.
;;
;; The book's habits.  In a product: the number, symbols by the alphabet, other
;; kernels with the highest derivatives last.  In a sum: terms in the order of
;; their kernels, higher powers first, so that a residual is grouped by its
;; symbols and then by its highest derivatives.

(require "kernel.rkt" "order.rkt" "exponentials.rkt")

(provide (struct-out term) make-term term-sort
         multiply-powers invert-powers scale-terms multiply-terms
         extract-content positive-powers negative-powers by-rank)

;; powers : ((kernel . exponent) ...), by ascending place, exponents not 0
(struct term (coefficient powers) #:authentic)

;; powers in any order, a kernel perhaps more than once
(define (make-term coefficient powers)
  (term coefficient
        (for/fold ([product '()]) ([p (in-list powers)]) (multiply-powers product (list p)))))

;; ---------------------------------------------------------------------------
;; Order

(define (term-sort terms)
  (if (ormap has-exponential? terms)
      (sort-by-exponents terms)
      (sort terms powers<? #:key term-powers)))

;; Which exponentials are basic depends on those that occurred, so they do not
;; decide except by their product.
(define (sort-by-exponents terms)
  (define compare (make-order))
  (define keys
    (for/list ([t (in-list terms)])
      (define-values (exponential others) (combine-exponentials (term-powers t)))
      (vector (filter (lambda (p) (not (exponential-power? p))) (term-powers t))
              (or exponential 0)
              t)))
  (define (before? a b)
    (cond [(powers<? (vector-ref a 0) (vector-ref b 0)) #t]
          [(powers<? (vector-ref b 0) (vector-ref a 0)) #f]
          [else (< (compare (vector-ref b 1) (vector-ref a 1)) 0)]))
  (map (lambda (key) (vector-ref key 2)) (sort keys before?)))

(define (exponential-power? p) (exponential? (kernel-relation (car p))))
(define (has-exponential? t) (ormap exponential-power? (term-powers t)))

(define (powers<? as bs)
  (cond [(null? as) #f]
        [(null? bs) #t]
        [else
         (define i (kernel-place (caar as)))
         (define j (kernel-place (caar bs)))
         (cond [(< i j) #t]
               [(> i j) #f]
               [(eqv? (cdar as) (cdar bs)) (powers<? (cdr as) (cdr bs))]
               [else (> (cdar as) (cdar bs))])]))

;; Powers in the order of a product.
(define (by-rank powers)
  (if (or (null? powers) (null? (cdr powers)))
      powers
      (sort powers < #:key (lambda (p) (kernel-rank (car p))))))

(define (positive-powers powers)
  (for/list ([p (in-list powers)] #:when (positive? (cdr p))) p))

(define (negative-powers powers)
  (for/list ([p (in-list powers)] #:when (negative? (cdr p)))
    (cons (car p) (- (cdr p)))))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (multiply-powers as bs)
  (cond [(null? as) bs]
        [(null? bs) as]
        [else
         (define i (kernel-place (caar as)))
         (define j (kernel-place (caar bs)))
         (cond [(< i j) (cons (car as) (multiply-powers (cdr as) bs))]
               [(> i j) (cons (car bs) (multiply-powers as (cdr bs)))]
               [else
                (define e (+ (cdar as) (cdar bs)))
                (define rest (multiply-powers (cdr as) (cdr bs)))
                (if (eqv? e 0) rest (cons (cons (caar as) e) rest))])]))

(define (invert-powers powers)
  (for/list ([p (in-list powers)]) (cons (car p) (- (cdr p)))))

(define (scale-terms c terms)
  (if (eqv? c 1)
      terms
      (for/list ([t (in-list terms)])
        (term (* c (term-coefficient t)) (term-powers t)))))

(define (multiply-terms terms powers)
  (if (null? powers)
      terms
      (for/list ([t (in-list terms)])
        (term (term-coefficient t) (multiply-powers (term-powers t) powers)))))

;; ---------------------------------------------------------------------------
;; Content

;; terms = c · powers · core, where the core has coprime integer coefficients,
;; not all negative, and no kernel to a negative power or in every term; or, if
;; `shared?`, only what all terms share is taken out: no common denominator.
(define (extract-content terms [shared? #f])
  (define c (content (map term-coefficient terms)))
  (define signed
    (if (andmap (lambda (t) (negative? (term-coefficient t))) terms) (- c) c))
  (define powers
    (for/fold ([common (term-powers (car terms))]) ([t (in-list (cdr terms))])
      (common-powers common (term-powers t) shared?)))
  (values signed powers
          (multiply-terms (scale-terms (/ 1 signed) terms) (invert-powers powers))))

(define (content cs)
  (/ (apply gcd (map numerator cs)) (apply lcm (map denominator cs))))

;; For each kernel the lesser exponent, absence counting as 0; or what is shared:
;; the one nearer to 0.  Exponentials know no denominators.
(define (common-powers as bs shared?)
  (define (lesser p q rest)
    (define m (if p (cdr p) 0))
    (define n (if q (cdr q) 0))
    (define e
      (cond [(not (or shared? (exponential? (kernel-relation (car (or p q)))))) (min m n)]
            [(and (positive? m) (positive? n)) (min m n)]
            [(and (negative? m) (negative? n)) (max m n)]
            [else 0]))
    (if (eqv? e 0) rest (cons (cons (car (or p q)) e) rest)))
  (cond [(and (null? as) (null? bs)) '()]
        [(null? bs) (lesser (car as) #f (common-powers (cdr as) bs shared?))]
        [(null? as) (lesser #f (car bs) (common-powers as (cdr bs) shared?))]
        [else
         (define i (kernel-place (caar as)))
         (define j (kernel-place (caar bs)))
         (cond [(< i j) (lesser (car as) #f (common-powers (cdr as) bs shared?))]
               [(> i j) (lesser #f (car bs) (common-powers as (cdr bs) shared?))]
               [else (lesser (car as) (car bs) (common-powers (cdr as) (cdr bs) shared?))])]))
