#lang racket/base
;; Squares of sums, found again among the terms of a sum.
;;
;; Two terms a X², b Y² of one sign whose product is a square, and a third that
;; is twice the root of it, are
;;
;;     c (α² X² ± 2 α β X Y + β² Y²) = c (α X ± β Y)²,
;;
;; so ½ k l² - k l x + ½ k x² is ½ k (l - x)².  To these a further square is added
;; as long as its products with all are there.  A term serves once, the first of
;; a sum first.
;;
;; In rotating axes the kinetic energy ½ m (ẋ - ω y)² + ½ m (ẏ + ω x)² is better
;; known by the powers of ω.  So where several squares have one content, they stay
;; squares only if their members are alike, x and y, not ẋ and ω y.

(require racket/list
         "term.rkt"
         "../kernel/kernel.rkt")

(provide merge-squares)

;; Sums of more terms are left alone.
(define limit 40)

;; terms : in the order of a sum; sum->kernel : terms -> the kernel of their sum
(define (merge-squares terms sum->kernel)
  (if (not (<= 3 (length terms) limit))
      terms
      (let-values ([(squares rest) (find-squares terms)])
        (define kept (filter (lambda (s) (welcome? s squares)) squares))
        (append (map (lambda (s) (square-term s sum->kernel)) kept)
                rest
                (append-map square-terms (remq* kept squares))))))

;; The terms it is made of, and content · (Σ members)².
(struct square (terms content members) #:authentic)

(define (square-term s sum->kernel)
  (define content (square-content s))
  (define below (denominators (square-members s) content))
  (define members (multiply-terms (reverse (square-members s)) below))
  (make-term (term-coefficient content)
             (cons (cons (sum->kernel members) 2)
                   (divide-powers (divide-powers (term-powers content) below) below))))

;; Powers that clear the members' denominators; those of symbols where the content has them, so
;; that a² (b + c/a)² is (a b + c)², which has a value at a = 0.
(define (denominators members content)
  (define all
    (for/fold ([powers '()]) ([m (in-list members)])
      (combine-powers (lambda (k m n) (max 0 m (- n))) powers (term-powers m))))
  (define (clearing k m n) (if (or (<= (* 2 m) n) (not (symbol? (kernel-expression k)))) m 0))
  (combine-powers clearing all (term-powers content)))

(define (welcome? s squares)
  (or (alike? (square-members s))
      (for/and ([other (in-list squares)])
        (or (eq? other s)
            (not (same-powers? (term-powers (square-content s))
                               (term-powers (square-content other))))))))

;; Have all members the same number of symbols?
(define (alike? members)
  (define (degree m)
    (for/sum ([p (in-list (term-powers m))])
      (if (symbol? (kernel-expression (car p))) (cdr p) 0)))
  (= 1 (length (remove-duplicates (map degree members)))))

;; -> squares and the terms that are left
(define (find-squares terms)
  (define found (find-square terms))
  (if found
      (let-values ([(squares rest)
                    (find-squares (remq* (square-terms found) terms))])
        (values (cons found squares) rest))
      (values '() terms)))

;; Terms whose product is a square have exponents of the same parity; exponentials
;; are to be the same.
(define (find-square terms)
  (define classes (make-hash))
  (for ([t (in-list (reverse terms))])
    (hash-update! classes (parity t) (lambda (ts) (cons t ts)) '()))
  (for*/or ([t (in-list terms)]
            [class (in-value (hash-ref classes (parity t)))]
            #:when (pair? (cdr class))
            [u (in-list (cdr (memq t class)))])
    (define s (make-square t u terms))
    (and s
         (for/fold ([s s]) ([w (in-list class)])
           (or (and (not (memq w (square-terms s))) (extend s w terms)) s)))))

(define (parity t)
  (for/list ([p (in-list (term-powers t))]
             #:when (or (odd? (cdr p)) (exponential-power? p)))
    (cons (kernel-place (car p)) (if (exponential-power? p) (cdr p) 'odd))))

;; ---------------------------------------------------------------------------
;; Two squares and their product, then more

;; The square that t and u are part of, or #f.
(define (make-square t u terms)
  (define ratio (rational-root (/ (term-coefficient u) (term-coefficient t))))
  (define shared (and ratio (shared-part (term-powers t) (term-powers u))))
  (and ratio
       (extend (square (list t)
                       (term (/ (term-coefficient t) (expt (denominator ratio) 2)) shared)
                       (list (term (denominator ratio) (root-of (term-powers t) shared))))
               u terms)))

;; The square with the root of w as one more member, or #f if a product of it with
;; the others is missing.
(define (extend s w terms)
  (define content (square-content s))
  (define ratio (rational-root (/ (term-coefficient w) (term-coefficient content))))
  (define new
    (and ratio
         (andmap even? (map cdr (divide-powers (term-powers w) (term-powers content))))
         (term ratio (root-of (term-powers w) (term-powers content)))))
  (define products
    (and new
         (for/list ([m (in-list (square-members s))])
           (find-product (double-product content m new) terms (square-terms s)))))
  (define sign (and products (andmap values products) (common-sign (map car products))))
  (and sign
       (square (append (cons w (map cdr products)) (square-terms s))
               content
               (cons (term (* sign ratio) (term-powers new)) (square-members s)))))

(define (double-product content m n)
  (term (* 2 (term-coefficient content) (term-coefficient m) (term-coefficient n))
        (multiply-powers (term-powers content)
                         (multiply-powers (term-powers m) (term-powers n)))))

;; (±1 . the term that is ± the product), or #f.
(define (find-product product terms used)
  (for/first ([t (in-list terms)]
              #:when (= (abs (term-coefficient t)) (abs (term-coefficient product)))
              #:when (same-powers? (term-powers t) (term-powers product))
              #:unless (memq t used))
    (cons (if (= (term-coefficient t) (term-coefficient product)) 1 -1) t)))

(define (common-sign signs)
  (and (= 1 (length (remove-duplicates signs))) (car signs)))

;; ---------------------------------------------------------------------------
;; Roots

;; √x if that is rational, else #f.
(define (rational-root x)
  (and (positive? x)
       (let ([root (sqrt x)]) (and (exact? root) root))))

;; The root of the powers divided by the shared ones.
(define (root-of powers shared)
  (for/list ([p (in-list (divide-powers powers shared))])
    (cons (car p) (quotient (cdr p) 2))))

;; Are they equal?  Quicker than equal?, which compares the contents of kernels.
(define (same-powers? as bs)
  (cond [(null? as) (null? bs)]
        [(null? bs) #f]
        [else (and (eq? (caar as) (caar bs))
                   (eqv? (cdar as) (cdar bs))
                   (same-powers? (cdr as) (cdr bs)))]))

;; The powers two products have in common, so that even ones are left.
(define (shared-part as bs)
  (define (shared k m n)
    (cond [(positive? (* m n)) (nearer-to-zero m n)]
          [(even? m) 0]
          [else (min m n)]))
  (combine-powers shared as bs))
