#lang racket/base
;; The value of an S-expression at a real point, for certain.
;;
;; A value is an exact rational as long as it can be one, else an interval.  Every
;; part must be real: roots of what is negative, logarithms of what is not positive,
;; a division by zero mean that there is no value; where an interval leaves that open
;; the value is not known.

(require racket/list
         "interval.rkt" "polynomial.rkt")

(provide (struct-out point) value-at value? sign-of differ? value->exact
         add multiply integer-power as-interval)

;; symbols : symbol -> exact rational, interval or #f
;; function : head, orders of derivative by position, values of arguments, arithmetic
;;            -> value
;; decimal : flonum, arithmetic -> value
(struct point (symbols function decimal) #:authentic)

(define (value? v) (or (real? v) (interval? v)))

;; -> value, or the no-value or too-hard it met
(define (value-at e where A)
  (with-handlers ([no-value? values] [too-hard? values])
    (evaluate e where A)))

(define (evaluate e where A)
  (cond [(eq? e ':pi) (half-turn A)]
        [(symbol? e) (or ((point-symbols where) e) (fail-unknown))]
        [(flonum? e) ((point-decimal where) e A)]
        [(number? e) (if (and (real? e) (exact? e)) e (fail-outside))]
        [(interval? e) e]
        [(not (and (pair? e) (list? e))) (fail-unknown)]
        [else
         (apply-head (car e) (for/list ([a (in-list (cdr e))]) (evaluate a where A)) where A)]))

(define (apply-head head args where A)
  (define f (and (symbol? head) (hash-ref operations head #f)))
  (cond [f (f A args)]
        [else
         (define-values (name orders) (parse-head head (length args)))
         ((point-function where) name orders args A)]))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define exact-bits 400)

(define (exact-enough? q)
  (and (< (integer-length (numerator q)) exact-bits)
       (< (integer-length (denominator q)) exact-bits)))

(define (as-interval A v) (if (interval? v) v ((arithmetic-from A) v)))
(define (settled A q) (if (exact-enough? q) q ((arithmetic-from A) q)))

(define-syntax-rule (define-binary name exact-name field)
  (define (name A u v)
    (if (and (real? u) (real? v))
        (settled A (exact-name u v))
        ((field A) (as-interval A u) (as-interval A v)))))

(define-binary add + arithmetic-add)
(define-binary subtract - arithmetic-subtract)
(define-binary multiply-any * arithmetic-multiply)
(define-binary divide-any / arithmetic-divide)

(define (multiply A u v) (if (or (eqv? u 0) (eqv? v 0)) 0 (multiply-any A u v)))

;; -> 1, 0, -1, or #f where it is not known
(define (sign-of v)
  (cond [(real? v) (cond [(> v 0) 1] [(< v 0) -1] [else 0])]
        [(positive-interval? v) 1]
        [(negative-interval? v) -1]
        [(= 0 (interval-low v) (interval-high v)) 0]
        [else #f]))

(define (known-sign v) (or (sign-of v) (fail-unknown)))
(define (require-nonzero v) (when (eqv? 0 (known-sign v)) (fail-outside)))

(define (divide A u v)
  (require-nonzero v)
  (if (eqv? u 0) 0 (divide-any A u v)))

(define (negate A v) (subtract A 0 v))

;; ---------------------------------------------------------------------------
;; Powers and roots

(define power-limit 100000)

(define (integer-power A v n)
  (cond [(eqv? n 0) 1]
        [(negative? n) (divide A 1 (integer-power A v (- n)))]
        [(> n power-limit) (fail-unknown)]
        [(and (real? v) (< (* n (+ 1 (integer-length (numerator v)))) 2000)
              (< (* n (+ 1 (integer-length (denominator v)))) 2000))
         (settled A (expt v n))]
        [else ((arithmetic-integer-power A) (as-interval A v) n)]))

(define (power A base n)
  (cond [(and (real? n) (integer? n)) (integer-power A base n)]
        [(real? n) (fractional-power A base n)]
        [else (require-positive base) (exponential A (multiply A n (logarithm A base)))]))

(define (fractional-power A base n)
  (define s (sign-of base))
  (cond [(eqv? s -1) (fail-outside)]
        [(eqv? s 0) (if (positive? n) 0 (fail-outside))]
        [(eqv? 2 (denominator n)) (integer-power A (root A base) (numerator n))]
        [(eqv? 4 (denominator n)) (integer-power A (root A (root A base)) (numerator n))]
        [(not s) (fail-unknown)]
        [else (exponential A (multiply A n (logarithm A base)))]))

(define (root A v)
  (when (eqv? -1 (sign-of v)) (fail-outside))
  (unless (sign-of v) (unless (zero? (interval-low v)) (fail-unknown)))
  (or (and (real? v) (exact-root v))
      ((arithmetic-sqrt A) (as-interval A v))))

(define (exact-root q)
  (define n (integer-sqrt (numerator q)))
  (define d (integer-sqrt (denominator q)))
  (and (= (* n n) (numerator q)) (= (* d d) (denominator q)) (/ n d)))

;; ---------------------------------------------------------------------------
;; Elementary functions

(define ((function at exact-argument exact-value) A v)
  (if (eqv? v exact-argument) exact-value ((at A) (as-interval A v))))

(define exponential (function arithmetic-exp 0 1))
(define sine (function arithmetic-sin 0 0))
(define cosine (function arithmetic-cos 0 1))
(define arc-tangent (function arithmetic-atan 0 0))
(define positive-logarithm (function arithmetic-log 1 0))

(define (require-positive v) (unless (eqv? 1 (known-sign v)) (fail-outside)))

(define (logarithm A v) (require-positive v) (positive-logarithm A v))
(define (tangent A v) (divide A (sine A v) (cosine A v)))

(define (half A v) (multiply A 1/2 v))
(define (inverse-exponential A v) (exponential A (negate A v)))
(define (hyperbolic-sine A v)
  (if (eqv? v 0) 0 (half A (subtract A (exponential A v) (inverse-exponential A v)))))
(define (hyperbolic-cosine A v)
  (half A (add A (exponential A v) (inverse-exponential A v))))

(define (square A v) (integer-power A v 2))
(define (half-turn A) ((arithmetic-pi A)))

;; asin x = atan (x/√(1 - x²)), with its ends.
(define (arc-sine A x)
  (define room (subtract A 1 (square A x)))
  (case (sign-of room)
    [(1) (arc-tangent A (divide A x (root A room)))]
    [(0) (multiply A (known-sign x) (half A (half-turn A)))]
    [(-1) (fail-outside)]
    [else (fail-unknown)]))
(define (arc-cosine A x)
  (if (eqv? x 1) 0 (subtract A (half A (half-turn A)) (arc-sine A x))))

;; The angle of the point (x, y), in (-π, π].
(define (angle A y x)
  (define-values (sx sy) (values (sign-of x) (sign-of y)))
  (cond [(eqv? sx 1) (arc-tangent A (divide A y x))]
        [(memv sy '(1 -1))
         (subtract A (multiply A sy (half A (half-turn A))) (arc-tangent A (divide A x y)))]
        [(and (eqv? sx -1) (eqv? sy 0)) (half-turn A)]
        [(and (eqv? sx 0) (eqv? sy 0)) (fail-outside)]
        [else (fail-unknown)]))

(define (inverse-hyperbolic-sine A x)
  (case (sign-of x)
    [(0) 0]
    [(-1) (negate A (inverse-hyperbolic-sine A (negate A x)))]
    [else (logarithm A (add A x (root A (add A 1 (square A x)))))]))
(define (inverse-hyperbolic-cosine A x)
  (case (sign-of (subtract A x 1))
    [(-1) (fail-outside)]
    [(#f) (fail-unknown)]
    [else (logarithm A (add A x (root A (subtract A (square A x) 1))))]))
(define (inverse-hyperbolic-tangent A x)
  (half A (logarithm A (divide A (add A 1 x) (subtract A 1 x)))))
(define (checked-artanh A x)
  (case (sign-of (subtract A 1 (square A x)))
    [(1) (inverse-hyperbolic-tangent A x)]
    [(#f) (fail-unknown)]
    [else (fail-outside)]))

;; erf v = 2/√π · e^(-v²) (v + 2v³/3 + 4v⁵/15 + ...), whose terms have one sign; each is less than
;; half the one before as soon as n > 2v², and then all that follow are less than the last.
(define (error-function A v)
  (define i (as-interval A v))
  (define size (max (abs ((arithmetic-to-real A) (interval-low i)))
                    (abs ((arithmetic-to-real A) (interval-high i)))))
  (when (> size 12) (fail-unknown))
  (define double (multiply A 2 (square A i)))
  (define-values (sum last)
    (for/fold ([sum i] [term i]) ([n (in-range (+ 300 (ceiling (* 4 size size))))])
      (define next (divide A (multiply A term double) (+ (* 2 n) 3)))
      (values (add A sum next) next)))
  (define all (add A sum ((arithmetic-join A) (as-interval A 0) (as-interval A last))))
  (if (eqv? v 0)
      0
      (divide A (multiply A 2 (multiply A (inverse-exponential A (square A i)) all))
              (root A (half-turn A)))))

(define (modulus A v)
  (case (sign-of v)
    [(1 0) v]
    [(-1) (negate A v)]
    [else (interval (interval-low (as-interval A 0))
                    (max (- (interval-low v)) (interval-high v)))]))

(define (sign A v) (known-sign v))

;; ---------------------------------------------------------------------------
;; Names

(define ((unary f) A args) (if (eqv? 1 (length args)) (f A (first args)) (fail-unknown)))
(define ((binary f) A args)
  (if (eqv? 2 (length args)) (f A (first args) (second args)) (fail-unknown)))
(define ((of-any f start) A args) (for/fold ([v start]) ([a (in-list args)]) (f A v a)))
(define ((of-first f start) A args)
  (if (null? (cdr args))
      (f A start (car args))
      (for/fold ([v (car args)]) ([a (in-list (cdr args))]) (f A v a))))

(define operations
  (for/hasheq
      ([entry
        (in-list
         (list (list '+ (of-any add 0)) (list '* (of-any multiply 1))
               (list '- (of-first subtract 0)) (list '/ (of-first divide 1))
               (list 'expt (binary power)) (list 'sqrt (unary root))
               (list 'square (unary square))
               (list 'cube (unary (lambda (A v) (integer-power A v 3))))
               (list 'exp (unary exponential)) (list 'log (unary logarithm))
               (list 'sin (unary sine)) (list 'cos (unary cosine)) (list 'tan (unary tangent))
               (list 'asin (unary arc-sine)) (list 'acos (unary arc-cosine))
               (list 'atan (lambda (A args)
                             ((if (null? (cdr args)) (unary arc-tangent) (binary angle)) A args)))
               (list 'sinh (unary hyperbolic-sine)) (list 'cosh (unary hyperbolic-cosine))
               (list 'tanh (unary (lambda (A v)
                                    (divide A (hyperbolic-sine A v) (hyperbolic-cosine A v)))))
               (list 'asinh (unary inverse-hyperbolic-sine))
               (list 'acosh (unary inverse-hyperbolic-cosine))
               (list 'atanh (unary checked-artanh))
               (list 'erf (unary error-function))
               (list 'abs (unary modulus)) (list 'sgn (unary sign))))])
    (values (first entry) (second entry))))

;; ---------------------------------------------------------------------------
;; Comparison

(define (differ? u v A)
  (if (and (real? u) (real? v))
      (not (= u v))
      (apart? (as-interval A u) (as-interval A v))))

;; A rational number near the value.
(define (value->exact v A)
  (if (real? v)
      v
      (/ (+ ((arithmetic-to-real A) (interval-low v)) ((arithmetic-to-real A) (interval-high v)))
         2)))
