#lang racket/base
;; Values of a program as sums of products (sum-terms.rkt).
;;
;; x − y and y − x are one factor with a sign, and numbers go outwards from products and quotients:
;; factors that differ by a number are found to be the same.  Sums are not multiplied out, unless
;; that leaves less (reduced-sums.rkt).  Values are those of the program up to rounding, as long as
;; products of several factors, taken in another order, stay in the range of flonums.

(require "flonum-coefficients.rkt" "program.rkt" "reduced-sums.rkt" "sum-terms.rkt")

(provide program->sums split!)

;; -> the factors, and the outputs as sums
(define (program->sums p)
  (define n (program-inputs p))
  (define f (make-factors))
  (define uses (program-uses p))
  (define sums (make-vector (+ n (program-length p)) #f))
  (define (of x)
    (if (place? x) (vector-ref sums (place-index x)) (constant! f (real->double-flonum x))))
  (for ([k (in-range n)]) (vector-set! sums k (factor-sum (intern! f (list 'input k)))))
  (for ([i (in-vector (program-instructions p))] [k (in-naturals n)])
    (define s (instruction->sum f i of))
    (vector-set! sums k (if (> (vector-ref uses k) 1) (single f s) s)))
  (values f (for/list ([o (in-vector (program-outputs p))]) (reduced f (of o)))))

(define (instruction->sum f i of)
  (define operands (instruction-operands i))
  (define (argument k) (of (list-ref operands k)))
  (case (instruction-operation i)
    [(add) (plus (argument 0) (argument 1))]
    [(subtract) (plus (argument 0) (negative (argument 1)))]
    [(negate) (negative (argument 0))]
    [(multiply) (times! f (argument 0) (argument 1))]
    [(divide) (over! f (argument 0) (argument 1))]
    [(component) (factor-sum (intern! f (list 'component (cadr operands) (argument 0))))]
    [else (operation! f (instruction-operation i) (map of operands))]))

(define (factor-sum id) (list (list 1.0 id)))

(define (constant! f c)
  (if (moderate? c) (list (list c)) (factor-sum (intern! f (list 'constant c)))))

(define (operation! f name sums)
  (define operands (for/list ([s (in-list sums)]) (reduced f s)))
  (factor-sum (intern! f (list* 'operation name operands))))

;; The number that a sum is, or #f
(define (constant-of s)
  (and (pair? s) (null? (cdr s)) (null? (monomial (car s))) (coefficient (car s))))

;; ---------------------------------------------------------------------------
;; Products and quotients

(define longest-monomial 16)

(define (times! f s r)
  (define-values (c d) (values (constant-of s) (constant-of r)))
  (define (opaque) (operation! f 'multiply (list s r)))
  (define (scaled-or-opaque c s)
    (define product (scaled c s))
    (if (andmap (lambda (t) (moderate? (coefficient t))) product) product (opaque)))
  (cond [(or (null? s) (null? r)) '()]
        [c (scaled-or-opaque c r)]
        [d (scaled-or-opaque d s)]
        [else
         (define-values (c m) (split! f s))
         (define-values (d n) (split! f r))
         (if (and (moderate? (* c d)) (<= (+ (length m) (length n)) longest-monomial))
             (list (cons (* c d) (foldl with-factor m n)))
             (opaque))]))

;; A number over something else stays one quotient.
(define (over! f s r)
  (define-values (c m) (split! f s))
  (define-values (d n) (split! f r))
  (cond [(null? s) '()]
        [(or (null? m) (null? n)) (operation! f 'divide (list s r))]
        [else
         (define q (exact-quotient c d))
         (define id (intern! f (list 'inverse (cons (if q 1.0 d) n))))
         (list (cons (or q c) (with-factor id m)))]))

;; ---------------------------------------------------------------------------
;; A sum as a number times a monomial

(define (single f s)
  (cond [(or (null? s) (null? (cdr s))) s]
        [else (define-values (c m) (split! f s))
              (list (cons c m))]))

;; -> c and the monomial that is s/c
(define (split! f sum)
  (define s (reduced f sum))
  (cond [(null? s) (values 1.0 (list (intern! f '(constant 0.0))))]
        [(null? (cdr s)) (values (coefficient (car s)) (monomial (car s)))]
        [else
         (define c (common-coefficient s))
         (define r (for/list ([t (in-list s)]) (cons (/ (coefficient t) c) (monomial t))))
         (define key (cons 'sum (sort r monomial<? #:key monomial)))
         (values c (list (intern! f (cons 'sum r) key)))]))

;; That of the least monomial, if this saves a multiplication; else its sign.
(define (common-coefficient s)
  (define c (coefficient (argmin-monomial s)))
  (define (same? t) (= (abs c) (abs (coefficient t))))
  (define (free? t) (or (null? (monomial t)) (unit? t)))
  (if (or (andmap same? s)
          (and (not (ormap free? s)) (andmap (lambda (t) (exact-quotient (coefficient t) c)) s)))
      c
      (if (< c 0.0) -1.0 1.0)))

(define (argmin-monomial s)
  (for/fold ([least (car s)]) ([t (in-list (cdr s))])
    (if (monomial<? (monomial t) (monomial least)) t least)))
