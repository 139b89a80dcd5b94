#lang racket/base
;; Sets of assumptions, and the signs that follow from them.
;;
;; An assumption gives the sign of an expression.  A set of them is an immutable
;; value: the relations as they were declared, and a table of all signs they
;; imply (narrowing.rkt), by the terms of an expression.
;;
;; The sign of any expression is then found from its structure (squares, roots,
;; exponentials ...), from the table, from its factors, and from the relations it is
;; a sum of.

(require racket/list
         "signs.rkt"
         "../expression/exact-numbers.rkt" "../expression/expression.rkt"
         (only-in "../expression/numeric-functions.rkt" sgn)
         "../expression/operation.rkt" "../expression/pi.rkt" "../expression/simplifier.rkt")

(provide
 ;; sets
 no-assumptions (struct-out assumptions) with-automatic-assumptions with-reference with-domain
 (struct-out relation)
 ;; known signs
 (struct-out known) unknown single?
 meet derive scaled known-sum known-product known-power
 ;; signs
 infer-signs real-valued? plainly-real? normalized)

;; datum : as declared, such as (>= r 0); expression has one of the signs.
(struct relation (datum expression signs) #:transparent)

;; Signs, and the datums of the relations they follow from.
(struct known (signs because) #:transparent)

;; relations : in the order of declaration    table : normalized terms -> known
;; sums : keys of the table that have several terms, from relations
;; automatic? : may simplification assume more by itself?
;; reference : #f, or -> the point at which it does so (reference-point.rkt), or #f
;; domain : expressions that are to have a real value wherever something is asked
(struct assumptions (relations table sums automatic? reference domain) #:authentic)

(define no-assumptions (assumptions '() (hash) '() #t #f '()))

(define (with-automatic-assumptions A automatic?)
  (struct-copy assumptions A [automatic? automatic?]))

(define (with-reference A point) (struct-copy assumptions A [reference point]))

;; es : expressions, none of which holds a number that is not real
(define (with-domain A es)
  (if (null? es) A (struct-copy assumptions A [domain (append es (assumptions-domain A))])))

;; ---------------------------------------------------------------------------
;; Known signs

(define (because-of signs) (known signs '()))
(define unknown (because-of any-sign))

(define (decided? k) (signs-decided? (known-signs k)))

;; The datums that the ks rest on.
(define (union ks) (remove-duplicates (append-map known-because ks)))

;; The relation that a and b make together for one expression.
(define (meet a b)
  (define s (bitwise-and (known-signs a) (known-signs b)))
  (cond [(eqv? s (known-signs a)) a]
        [(eqv? s (known-signs b)) b]
        [else (known s (union (list a b)))]))

;; Signs that say nothing rest on nothing.
(define (derive f . ks)
  (define s (apply f (map known-signs ks)))
  (known s (if (eqv? s any-sign) '() (union ks))))

(define (known-product ks)
  (for/fold ([p (because-of positive)]) ([k (in-list ks)]) (derive signs-product p k)))

(define (known-sum ks)
  (for/fold ([s (car ks)]) ([k (in-list (cdr ks))]) (derive signs-sum s k)))

(define (known-power k n) (derive (lambda (s) (signs-power s n)) k))

(define (scaled c k) (known-product (list (because-of (number-signs c)) k)))

;; ---------------------------------------------------------------------------
;; The sign of an expression

;; s : simplifier, used only if there are relations
;; -> known
(define (infer-signs A s e [limits (fresh-limits)])
  (node-fold e
             (lambda (leaf)
               (cond [(pi-multiple leaf) => (lambda (k) (because-of (number-signs k)))]
                     [(symbol? leaf) (look-up A (list (cons 1 leaf)))]
                     [(real? leaf) (because-of (number-signs leaf))]
                     [else not-real]))
             (lambda (n parts)
               (define k (if (memq not-real parts) (part-not-real n) (structural n parts)))
               (if (or (eq? k not-real) (null? (assumptions-relations A)))
                   k
                   (from-table A s n k limits)))))

;; Knowledge of a number that is not real, of a root or logarithm of an expression that is
;; never positive, and of an expression that contains one of these: no sign is excluded.
(define not-real (because-of any-sign))

(define (part-not-real n)
  (if (eq? (node-head n) op:abs) (because-of nonnegative) not-real))

;; Symbols are real, and so are roots and logarithms of terms that may be positive.
(define (real-valued? A s e)
  (or (plainly-real? e) (not (eq? (infer-signs A s e) not-real))))

;; Are all numbers in e real, and are there no roots and logarithms?
(define (plainly-real? e)
  (define (single-valued? n)
    (or (integer-power? n) (not (memq (node-head n) (list op:expt op:sqrt op:log)))))
  (node-fold e
             (lambda (leaf) (or (symbol? leaf) (real? leaf)))
             (lambda (n parts) (and (andmap values parts) (single-valued? n)))))

(define (structural n parts)
  (define head (node-head n))
  (cond [(eq? head op:+) (known-sum parts)]
        [(eq? head op:-) (known-sum (list (car parts) (derive signs-negate (cadr parts))))]
        [(eq? head op:*) (known-product parts)]
        [(eq? head op:/) (known-product (list (car parts) (known-power (cadr parts) -1)))]
        [(eq? head op:expt) (power-signs (car parts) (cadr (node-args n)))]
        [(eq? head op:sqrt) (power-signs (car parts) 1/2)]
        [(memq head positive-functions) (because-of positive)]
        [(eq? head op:acos) (because-of nonnegative)]
        [(eq? head op:log) (if (never-positive? (car parts)) not-real unknown)]
        [(eq? head op:abs) (known-power (car parts) 2)]
        [(and (memq head sign-keeping) (null? (cdr parts))) (car parts)]
        [else unknown]))

(define positive-functions (operations-where positive))
;; Functions that have the sign of their argument; of atan, where it has one.
(define sign-keeping (cons op:atan (operations-where odd increasing)))

(define (never-positive? k) (signs-within? (known-signs k) nonpositive))

;; Roots are taken where they may be real; if their sign is not decided by the base,
;; even ones are not negative there.
(define (power-signs base n)
  (define k (exact-exponent n))
  (cond [(integer? k) (known-power base k)]
        [(signs-within? (known-signs base) nonnegative) (known-power base (if k (sgn k) 1))]
        [(never-positive? base) not-real]
        [(and k (even? (denominator k))) (because-of nonnegative)]
        [else unknown]))

;; ---------------------------------------------------------------------------
;; Limits

;; depth : so many relations are added up, one upon the other
;; left : box of how many looks at the table one question may take
(struct limits (depth left) #:authentic)

(define (fresh-limits) (limits 2 (box 100)))

(define (deeper l) (limits (- (limits-depth l) 1) (limits-left l)))

(define (spend! l)
  (define b (limits-left l))
  (set-box! b (- (unbox b) 1))
  (positive? (unbox b)))

;; ---------------------------------------------------------------------------
;; The table

;; -> the terms divided by the first coefficient, exact; and that coefficient.
(define (normalized terms)
  (define c (inexact->exact (caar terms)))
  (values (for/list ([t (in-list terms)]) (cons (/ (inexact->exact (car t)) c) (cdr t)))
          c))

(define (look-up A terms)
  (define-values (key c) (normalized terms))
  (scaled c (hash-ref (assumptions-table A) key unknown)))

(define arithmetic (list op:+ op:- op:* op:/ op:expt))

(define (terms-of s n)
  (if (memq (node-head n) arithmetic) (simplifier-terms s n) (list (cons 1 n))))

(define (from-table A s n k limits)
  (define ts (terms-of s n))
  (define (or-else k more) (if (decided? k) k (meet k (more))))
  (if (and (spend! limits) (pair? ts) (andmap real-term? ts))
      (let* ([k (meet k (look-up A ts))]
             [k (or-else k (lambda () (from-sums A s ts limits)))])
        (or-else k (lambda () (from-factors A s ts n limits))))
      k))

(define (real-term? t) (and (rational? (car t)) (not (eqv? (car t) 0))))

;; By the factors of a sum, if there are several.
(define (from-factors A s ts n limits)
  (define-values (number factors)
    (if (null? (cdr ts)) (values 1 '()) (simplifier-irreducible-factors s n)))
  (if (single? factors)
      unknown
      (scaled number
              (known-product
               (for/list ([f (in-list factors)])
                 (known-power (infer-signs A s (car f) limits) (cdr f)))))))

;; No factors, or one to the first power?
(define (single? factors)
  (or (null? factors)
      (and (null? (cdr factors)) (eqv? 1 (cdar factors)))))

;; Signs of terms, seen as a multiple of a relation's sum and a rest.
(define (from-sums A s ts limits)
  (define (add-up sum t)
    (define own (coefficient (cdr t) sum))
    (define k (if own (by-sum A s ts sum (/ (inexact->exact (car t)) own) limits)
                  unknown))
    (and (decided? k) k))
  (or (and (> (limits-depth limits) 0)
           (pair? (cdr ts))
           (for*/or ([sum (in-list (assumptions-sums A))] [t (in-list ts)]) (add-up sum t)))
      unknown))

;; The terms are c · sum and a rest.
(define (by-sum A s ts sum c limits)
  (define rest (subtract ts sum c))
  (define k
    (known-sum
     (cons (because-of zero)
           (for/list ([t (in-list rest)])
             (scaled (car t) (infer-signs A s (cdr t) (deeper limits)))))))
  (derive signs-sum
          (scaled c (look-up A sum))
          (if (or (decided? k) (null? rest))
              k
              (meet (meet k (look-up A rest)) (from-sums A s rest (deeper limits))))))

;; ts - c · sum, the terms in the order of ts.
(define (subtract ts sum c)
  (append
   (for*/list ([t (in-list ts)]
               [x (in-value (- (inexact->exact (car t))
                               (* c (or (coefficient (cdr t) sum) 0))))]
               #:unless (eqv? x 0))
     (cons x (cdr t)))
   (for/list ([u (in-list sum)] #:unless (coefficient (cdr u) ts))
     (cons (* (- c) (car u)) (cdr u)))))

(define (coefficient e ts)
  (for/first ([t (in-list ts)] #:when (equal? (cdr t) e)) (car t)))
