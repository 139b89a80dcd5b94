#lang racket/base
;; Operators: functions of functions whose product is composition.
;;
;; Sums and multiples act pointwise, (A + B) f = A f + B f; the product of
;; operators composes, (A B) f = A (B f), and powers repeat.  A number stands
;; for that multiple of the identity, a function or tuple for multiplication
;; by it (SICM p. 516).  The exponential is the operator
;;
;;   exp(A) f = f + A f + A² f/2! + ⋯,
;;
;; whose values are series.

(require "series/coefficients.rkt" "series/series.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/dispatch.rkt"
         "../generic/elementary.rkt" "../generic/function.rkt" "../generic/kind.rkt"
         "../generic/scalar.rkt" "../generic/value-struct.rkt" "../generic/wrong-argument.rkt")

(provide make-operator make-primitive-operator operator?
         I-operator commutator anticommutator)

(define kind:operator
  (make-kind #:rank rank:operator
             #:describe (lambda (o) "an operator")
             #:datum (lambda (o) ((operator-make-datum o)))
             #:unary function-of-operator
             #:binary combine-operators))

;; procedure : function -> function.  make-datum : -> the datum that the operator prints as.
;; iterate : n -> the procedure of the power n > 1, where there is a better way than
;; to repeat; or #f.  power : the power of which it is a multiple, or #f.
(value-struct operator (procedure make-datum iterate power)
  #:kind kind:operator
  #:property prop:procedure
  (case-lambda
    [(o f) ((operator-procedure o) f)]
    [(o . fs) (apply (operator-procedure o) fs)]))

;; The operator of this procedure, printing as `name`; the image of a function
;; prints as the application that made it.  The subtype and arity of scmutils are taken,
;; and not needed.
(define (make-operator procedure [name (procedure-datum procedure)] [subtype #f] [arity #f])
  (check-argument 'make-operator procedure? procedure "a function of functions")
  (naming-images procedure (lambda () (value->datum name))))

;; An operator whose procedure names its images itself.
(define (make-primitive-operator procedure make-datum #:iterate [iterate #f])
  (operator procedure make-datum iterate #f))

(define (naming-images procedure make-datum #:power [power #f])
  (operator
   (lambda fs
     (define image (apply procedure fs))
     (if (pointwise? image)
         (make-function image (arity-mask image)
                        (lambda () (cons (make-datum) (map value->datum fs))))
         image))
   make-datum
   #f
   power))

(define I-operator (make-primitive-operator (lambda (f) f) (lambda () 'I)))

;; ---------------------------------------------------------------------------
;; Algebra

(define (as-operator x)
  (if (operator? x)
      x
      (make-primitive-operator (lambda (f) (g:* x f)) (lambda () (value->datum x)))))

(define (combine-operators op a b)
  (case (generic-op-name op)
    [(+ -) (pointwise op a b)]
    [(*) (cond [(and (operator? a) (operator? b) (same-base? a b))
                (define p (power-in a))
                (power-of (power-base p) (+ (power-exponent p) (power-exponent (power-in b))))]
               [else (product a b)])]
    [(/) (if (operator? b) (raise-inapplicable op a b) (product (g:/ 1 b) a))]
    [(expt) (raise-to-power op a b)]
    [else (raise-inapplicable op a b)]))

(define (pointwise op a b)
  (define combine (generic-op-procedure op))
  (define f (operator-procedure (as-operator a)))
  (define g (operator-procedure (as-operator b)))
  (naming-images (lambda fs (combine (apply f fs) (apply g fs)))
                 (lambda () (list (generic-op-name op) (value->datum a) (value->datum b)))))

(define (product a b)
  (define f (operator-procedure (as-operator a)))
  (define g (operator-procedure (as-operator b)))
  (naming-images (lambda fs (f (apply g fs)))
                 (lambda () (list '* (value->datum a) (value->datum b)))
                 #:power (and (scalar? a) (operator? b) (multiple-of a (power-in b)))))

(define (commutator a b) (g:- (g:* a b) (g:* b a)))
(define (anticommutator a b) (g:+ (g:* a b) (g:* b a)))

;; ---------------------------------------------------------------------------
;; Powers: every operator is scale · baseⁿ, if only as 1 · itself.  That is kept in
;; sight, for the base may know its powers better than by repetition.  A scalar may be
;; drawn out, for every linear operator commutes with it.

(struct power (scale base exponent) #:authentic)

(define (power-in o) (or (operator-power o) (power 1 o 1)))

(define (multiple-of c p) (power (g:* c (power-scale p)) (power-base p) (power-exponent p)))

(define (same-base? a b)
  (define p (power-in a))
  (define q (power-in b))
  (and (eqv? (power-scale p) 1) (eqv? (power-scale q) 1) (eq? (power-base p) (power-base q))))

(define (raise-to-power op a n)
  (unless (operator? a) (raise-inapplicable op a n))
  (unless (exact-nonnegative-integer? n)
    (raise-inapplicable-because op "the powers of an operator are 0, 1, 2, ..." a n))
  (define p (power-in a))
  (case n
    [(0) I-operator]
    [(1) a]
    [else
     (if (eqv? (power-scale p) 1)
         (power-of (power-base p) (* n (power-exponent p)))
         (scaled-power a p n))]))

(define (power-of base n)
  (define iterate (operator-iterate base))
  (define procedure
    (if iterate
        (iterate n)
        (lambda (f) (for/fold ([f f]) ([_ (in-range n)]) ((operator-procedure base) f)))))
  (naming-images procedure (lambda () (list 'expt (value->datum base) n))
                 #:power (power 1 base n)))

(define (scaled-power a p n)
  (define scale (g:expt (power-scale p) n))
  (define whole (power-of (power-base p) (* n (power-exponent p))))
  (naming-images (lambda (f) (g:* scale (whole f)))
                 (lambda () (list 'expt (value->datum a) n))
                 #:power (power scale (power-base p) (* n (power-exponent p)))))

;; ---------------------------------------------------------------------------
;; The exponential

(define (function-of-operator op o)
  (case (generic-op-name op)
    [(exp) (make-primitive-operator (lambda (f) (exponential-of o f))
                                    (lambda () (list 'exp (value->datum o))))]
    [else (raise-inapplicable op o)]))

;; exp(A) is linear: of a series it is the series of the exponentials of its terms.
(define (exponential-of o f)
  (cond [(and (series? f) (not (power-series? f)))
         (collapse (map-series (lambda (x) (if (eqv? x 0) 0 (exponential-of o x))) f))]
        [else
         (define image (images o f))
         (series-of
          (make-coefficients
           (lambda (k)
             (case k
               [(0) f]
               [(1) (image 1)]
               [else (g:/ (image k) (factorial k))]))))]))

;; k -> Aᵏ f for k > 0
(define (images o f)
  (cond [(operator-iterate (power-base (power-in o)))
         (lambda (k) ((g:expt o k) f))]
        [else
         (define known
           (make-coefficients (lambda (k) (if (eqv? k 0) f (o (coefficient known (sub1 k)))))))
         (reader known)]))
