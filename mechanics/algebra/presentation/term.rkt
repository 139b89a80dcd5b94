#lang racket/base
;; Terms: a number times powers of kernels, in the order they are written.
;;
;; The book's habits.  In a product: the number, symbols by the alphabet, other
;; kernels with the highest derivatives last.  In a sum: terms in the order of
;; their kernels, higher powers first, so that a residual is grouped by its
;; symbols and then by its highest derivatives.

(require racket/list
         "../expression/exact-numbers.rkt" "../expression/order.rkt"
         "../kernel/exponentials.rkt" "../kernel/kernel.rkt")

(provide (struct-out term) make-term term-sort
         multiply-powers invert-powers scale-terms multiply-terms
         extract-content common-powers nearer-to-zero merge-powers
         exponential-power? has-exponential?
         positive-powers negative-powers by-rank)

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
      (vector (filter-not exponential-power? (term-powers t))
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
  (define c (rational-content (map term-coefficient terms)))
  (define signed
    (if (andmap (lambda (t) (negative? (term-coefficient t))) terms) (- c) c))
  (define powers
    (for/fold ([common (term-powers (car terms))]) ([t (in-list (cdr terms))])
      (common-powers common (term-powers t) shared?)))
  (values signed powers
          (multiply-terms (scale-terms (/ 1 signed) terms) (invert-powers powers))))

;; For each kernel the lesser exponent, absence counting as 0; or what is shared:
;; the one nearer to 0.  Exponentials are shared as a whole or not at all: which
;; of them are basic depends on those that occurred.
(define (common-powers as bs shared?)
  (define same? (same-exponentials? as bs))
  (define (lesser p q rest)
    (define m (if p (cdr p) 0))
    (define n (if q (cdr q) 0))
    (define e
      (cond [(exponential-power? (or p q)) (if same? m 0)]
            [shared? (nearer-to-zero m n)]
            [else (min m n)]))
    (if (eqv? e 0) rest (cons (cons (car (or p q)) e) rest)))
  (merge-powers lesser as bs))

(define (same-exponentials? as bs)
  (define (exponentials powers)
    (for/list ([p (in-list powers)] #:when (exponential-power? p))
      (cons (kernel-place (car p)) (cdr p))))
  (equal? (exponentials as) (exponentials bs)))

(define (nearer-to-zero m n)
  (cond [(and (positive? m) (positive? n)) (min m n)]
        [(and (negative? m) (negative? n)) (max m n)]
        [else 0]))

;; entry : the powers of one kernel in as and in bs, #f where it has none, and the
;; rest -> the rest with what the two make
(define (merge-powers entry as bs)
  (cond [(and (null? as) (null? bs)) '()]
        [(null? bs) (entry (car as) #f (merge-powers entry (cdr as) bs))]
        [(null? as) (entry #f (car bs) (merge-powers entry as (cdr bs)))]
        [else
         (define i (kernel-place (caar as)))
         (define j (kernel-place (caar bs)))
         (cond [(< i j) (entry (car as) #f (merge-powers entry (cdr as) bs))]
               [(> i j) (entry #f (car bs) (merge-powers entry as (cdr bs)))]
               [else (entry (car as) (car bs) (merge-powers entry (cdr as) (cdr bs)))])]))
