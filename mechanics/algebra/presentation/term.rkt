#lang racket/base
;; Terms: a number times powers of kernels, in the order they are written.
;;
;; The book's habits.  In a product: the number, symbols by the alphabet, other
;; kernels with the highest derivatives last.  In a sum: terms in the order of
;; their kernels, higher powers first, so that a residual is grouped by its
;; symbols and then by its highest derivatives.

(require racket/list
         "../expression/exact-numbers.rkt" "../expression/order.rkt"
         "../kernel/exponentials.rkt" "../kernel/kernel.rkt"
         (only-in "../polynomial/polynomial.rkt" raise-powers))

(provide (struct-out term) make-term term-sort constant-first group-in-order in-tails
         collect-powers combine-powers multiply-powers divide-powers invert-powers
         scale-terms multiply-terms extract-content common-powers nearer-to-zero
         exponential-power? has-exponential?
         positive-powers negative-powers by-rank)

;; powers : ((kernel . exponent) ...), by ascending place, exponents not 0
(struct term (coefficient powers) #:authentic)

;; powers in any order, a kernel perhaps more than once
(define (make-term coefficient powers) (term coefficient (collect-powers powers)))

;; The same powers by ascending place, each kernel once.
(define (collect-powers powers)
  (for/fold ([product '()]) ([p (in-list powers)]) (multiply-powers product (list p))))

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
  (define (key t)
    (define-values (exponential others) (combine-exponentials (term-powers t)))
    (cons (or exponential 0) (filter-not exponential-power? (term-powers t))))
  (define (before? a b)
    (cond [(powers<? (cdr a) (cdr b)) #t]
          [(powers<? (cdr b) (cdr a)) #f]
          [else (< (compare (car b) (car a)) 0)]))
  (sort terms before? #:key key #:cache-keys? #t))

;; The terms in order, but a positive constant comes first.
(define (constant-first terms)
  (define (constant? t) (and (null? (term-powers t)) (positive? (term-coefficient t))))
  (define-values (constants others) (partition constant? (term-sort terms)))
  (append constants others))

(define (exponential-power? p) (exponential-kernel? (car p)))
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

;; Like racket/list's group-by, in a third of the time: the lists of elements with equal keys, in
;; the order of their first ones.  Keys are best made of numbers, whose hashes are quick.
(define (group-in-order key xs)
  (define table (make-hash))
  (define keys
    (for/fold ([keys '()]) ([x (in-list xs)])
      (define k (key x))
      (define group (hash-ref table k '()))
      (hash-set! table k (cons x group))
      (if (null? group) (cons k keys) keys)))
  (for/list ([k (in-list (reverse keys))]) (reverse (hash-ref table k))))

;; The list of xs and its tails, '() left out.
(define (in-tails xs)
  (if (null? xs) '() (cons xs (in-tails (cdr xs)))))

;; Powers in the order of a product.
(define (by-rank powers) (sort powers < #:key (lambda (p) (kernel-rank (car p)))))

(define (positive-powers powers) (filter (lambda (p) (positive? (cdr p))) powers))
(define (negative-powers powers) (positive-powers (invert-powers powers)))

;; ---------------------------------------------------------------------------
;; Arithmetic

;; exponent : kernel, its exponents in as and in bs, 0 where it has none -> that in the result
(define (combine-powers exponent as bs)
  (define (next k m n as bs)
    (define e (exponent k m n))
    (define rest (combine-powers exponent as bs))
    (if (eqv? e 0) rest (cons (cons k e) rest)))
  (cond [(and (null? as) (null? bs)) '()]
        [(or (null? bs)
             (and (pair? as) (< (kernel-place (caar as)) (kernel-place (caar bs)))))
         (next (caar as) (cdar as) 0 (cdr as) bs)]
        [(or (null? as) (> (kernel-place (caar as)) (kernel-place (caar bs))))
         (next (caar bs) 0 (cdar bs) as (cdr bs))]
        [else (next (caar as) (cdar as) (cdar bs) (cdr as) (cdr bs))]))

(define (multiply-powers as bs) (combine-powers (lambda (k m n) (+ m n)) as bs))
(define (divide-powers as bs) (combine-powers (lambda (k m n) (- m n)) as bs))

(define (invert-powers powers) (raise-powers powers -1))

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
;; `shared?`, only the part that all terms share is taken out: no common denominator.
(define (extract-content terms [shared? #f])
  (define coefficients (map term-coefficient terms))
  (define c (rational-content coefficients))
  (define signed (if (andmap negative? coefficients) (- c) c))
  (define powers
    (for/fold ([common (term-powers (car terms))]) ([t (in-list (cdr terms))])
      (common-powers common (term-powers t) shared?)))
  (values signed powers
          (multiply-terms (scale-terms (/ 1 signed) terms) (invert-powers powers))))

;; For each kernel the lesser exponent, absence counting as 0; or the shared one:
;; the one nearer to 0.  Exponentials are shared as a whole or not at all: which
;; of them are basic depends on those that occurred.
(define (common-powers as bs shared?)
  (define same? (equal? (filter exponential-power? as) (filter exponential-power? bs)))
  (define (lesser k m n)
    (cond [(exponential-kernel? k) (if same? m 0)]
          [shared? (nearer-to-zero m n)]
          [else (min m n)]))
  (combine-powers lesser as bs))

(define (nearer-to-zero m n)
  (cond [(and (positive? m) (positive? n)) (min m n)]
        [(and (negative? m) (negative? n)) (max m n)]
        [else 0]))
