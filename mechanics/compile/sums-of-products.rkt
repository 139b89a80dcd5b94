#lang racket/base
;; Values of a program as sums of products.
;;
;; A *sum* is a list of terms, a *term* a number times a *monomial*, and a monomial the ascending
;; list of its factors' ids, () being 1.  A *factor* is
;;
;;     (input k)                   an input
;;     (constant c)                a number that is no coefficient
;;     (sum term ...)              a sum that is multiplied, or used more than once
;;     (inverse term ...)          1 over a sum of one term
;;     (operation name sum ...)    any other operation
;;     (component k sum)           of the solution of a system
;;
;; each once: x − y and y − x are one factor with a sign, and numbers go outwards from products and
;; quotients.  So what is the same but for a number is found to be the same.  Where sin² and cos² of
;; one angle have the same factors beside them, 1 − sin² is put for cos² or the other way round,
;; whichever adds numbers of one sign.
;;
;; Sums are not multiplied out, and their terms keep the order in which they were added.  Values
;; are those of the program up to rounding, as long as products of several factors, taken in another
;; order, stay in the range of flonums.

(require racket/list
         "program.rkt")

(provide program->sums coefficient monomial unit?
         factor-of sums-of map-sums split! without with-factor monomial<?)

(define coefficient car)
(define monomial cdr)
(define (unit? t) (= 1.0 (abs (coefficient t))))

;; ids : key -> id; items : id -> factor
(struct factors (ids items) #:authentic)

(define (factor-of f id) (hash-ref (factors-items f) id))

;; The id of a factor; key : of all that are the same
(define (intern! f factor [key factor])
  (define ids (factors-ids f))
  (or (hash-ref ids key #f)
      (let ([id (hash-count ids)])
        (hash-set! ids key id)
        (hash-set! (factors-items f) id factor)
        id)))

;; The sums that a factor is made of.
(define (sums-of factor)
  (case (car factor)
    [(sum inverse) (list (cdr factor))]
    [(operation component) (cddr factor)]
    [else '()]))

;; The factor with other sums in place of these.
(define (map-sums change factor)
  (case (car factor)
    [(sum inverse) (cons (car factor) (change (cdr factor)))]
    [(operation component) (list* (car factor) (cadr factor) (map change (cddr factor)))]
    [else factor]))

;; ---------------------------------------------------------------------------
;; From a program

;; -> the factors, and the outputs as sums
(define (program->sums p)
  (define n (program-inputs p))
  (define f (factors (make-hash) (make-hasheqv)))
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

;; Products and quotients of a few of these are flonums of full precision.
(define (moderate? c) (<= 1e-60 (abs c) 1e60))

;; The number that a sum is, or #f
(define (constant-of s)
  (and (pair? s) (null? (cdr s)) (null? (monomial (car s))) (coefficient (car s))))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (plus s more)
  (for/fold ([s s]) ([t (in-list more)]) (plus-term s t)))

(define (plus-term s t)
  (define old (term-of s (monomial t)))
  (if old
      (replaced s old (+ (coefficient old) (coefficient t)))
      (append s (list t))))

(define (term-of s m)
  (for/first ([t (in-list s)] #:when (equal? m (monomial t))) t))

;; With another coefficient for that of the term; without it, if that is 0.
(define (replaced s term c)
  (if (zero? c)
      (remq term s)
      (for/list ([t (in-list s)]) (if (eq? t term) (cons c (monomial t)) t))))

(define (negative s) (scaled -1.0 s))

(define (scaled c s)
  (for/list ([t (in-list s)]) (cons (* c (coefficient t)) (monomial t))))

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

;; What is a number over something else stays one quotient.
(define (over! f s r)
  (define-values (c m) (split! f s))
  (define-values (d n) (split! f r))
  (cond [(null? s) '()]
        [(or (null? m) (null? n) (not (moderate? (/ c d)))) (operation! f 'divide (list s r))]
        [else (define id (intern! f (list 'inverse (cons 1.0 n))))
              (list (cons (/ c d) (with-factor id m)))]))

(define (with-factor id m)
  (if (or (null? m) (<= id (car m))) (cons id m) (cons (car m) (with-factor id (cdr m)))))
(define (without id m) (remv id m))

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
  (if (and (or (andmap same? s) (not (ormap free? s)))
           (andmap (lambda (t) (moderate? (/ (coefficient t) c))) s))
      c
      (if (< c 0.0) -1.0 1.0)))

(define (argmin-monomial s)
  (for/fold ([least (car s)]) ([t (in-list (cdr s))])
    (if (monomial<? (monomial t) (monomial least)) t least)))

(define (monomial<? m n)
  (define difference (for/first ([i (in-list m)] [j (in-list n)] #:unless (= i j)) (- i j)))
  (if difference (< difference 0) (< (length m) (length n))))

;; ---------------------------------------------------------------------------
;; a cos² + b sin² = a + (b − a) sin² = b + (a − b) cos²

(define (reduced f s)
  (or (for*/or ([t (in-list s)] [id (in-list (monomial t))])
        (define rest (beside-square id (monomial t)))
        (define twin (and rest (twin-of f id)))
        (define other (and twin (term-of s (with-factor twin (with-factor twin rest)))))
        (and other
             (one-sign? (coefficient t) (coefficient other))
             (reduced f (without-one-square s t other rest))))
      s))

;; The other factors of a monomial that holds the square of one, or #f
(define (beside-square id m)
  (define others (without id m))
  (and (memv id others) (without id others)))

;; -> id of the cosine if it is that of a sine and there is one; or #f
(define (twin-of f id)
  (define factor (factor-of f id))
  (and (eq? 'operation (car factor))
       (eq? 'sin (cadr factor))
       (hash-ref (factors-ids f) (list* 'operation 'cos (cddr factor)) #f)))

;; Numbers of two signs cancel somewhere; they must do so wherever their sum is far from both.
(define (one-sign? a b) (or (> (* a b) 0.0) (< 1/16 (abs (/ a b)) 16)))

(define (without-one-square s t other rest)
  (define-values (a b) (values (coefficient t) (coefficient other)))
  (define-values (base kept change)
    (if (<= (abs a) (abs b)) (values t other (- b a)) (values other t (- a b))))
  (plus-term (replaced (remq base s) kept change) (cons (coefficient base) rest)))
