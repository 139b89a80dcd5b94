#lang racket/base
;; Operators: functions of functions whose product is composition.
;;
;; Sums and multiples act pointwise, (A + B) f = A f + B f; the product of
;; operators composes, (A B) f = A (B f), and powers repeat.  A number stands
;; for that multiple of the identity, a function or tuple for multiplication
;; by it (SICM p. 516).

(require "../generic/kind.rkt" "../generic/describe.rkt"
         "../generic/function.rkt" "../generic/structure.rkt"
         "../generic/dispatch.rkt" "../generic/arithmetic.rkt")

(provide make-operator make-primitive-operator operator? operator-procedure
         I-operator commutator anticommutator)

(define kind:operator
  (make-kind #:rank rank:operator
             #:describe (lambda (o) "an operator")
             #:datum (lambda (o) ((operator-make-datum o)))
             #:unary (lambda (op o) (raise-inapplicable op o))
             #:binary (lambda (op a b) (combine-operators op a b))))

;; procedure : function -> function.  make-datum : -> what the operator prints as.
;; power : (cons operator exponent) if it is a power of another, or #f.
(struct operator (procedure make-datum power)
  #:authentic
  #:property prop:kind kind:operator
  #:property prop:procedure
  (case-lambda
    [(o f) ((operator-procedure o) f)]
    [(o . fs) (apply (operator-procedure o) fs)])
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write (lambda (o port mode) (write-value o port)))

;; The operator of this procedure, printing as `name`; the image of a function
;; prints as the application that made it.
(define (make-operator procedure [name (procedure-datum procedure)])
  (unless (procedure? procedure)
    (raise-argument-error 'make-operator "a function of functions" procedure))
  (naming-images procedure (lambda () (value->datum name))))

;; One whose procedure gives its images their names itself.
(define (make-primitive-operator procedure make-datum)
  (operator procedure make-datum #f))

(define (naming-images procedure make-datum)
  (operator
   (lambda fs
     (define image (apply procedure fs))
     (if (pointwise? image)
         (make-function image (arity-mask image)
                        (lambda () (cons (make-datum) (map value->datum fs))))
         image))
   make-datum
   #f))

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
    [(*) (if (and (operator? a) (operator? b) (eq? (base-of a) (base-of b)))
             (power-of (base-of a) (+ (exponent-of a) (exponent-of b)))
             (product a b))]
    [(/) (if (operator? b) (raise-inapplicable op a b) (product (g:/ 1 b) a))]
    [(expt) (power op a b)]
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
                 (lambda () (list '* (value->datum a) (value->datum b)))))

(define (power op a n)
  (unless (and (operator? a) (exact-nonnegative-integer? n))
    (raise-inapplicable op a n))
  (if (operator-power a)
      (power-of (base-of a) (* n (exponent-of a)))
      (power-of a n)))

(define (power-of a n)
  (define f (operator-procedure a))
  (case n
    [(0) I-operator]
    [(1) a]
    [else (as-power (naming-images (lambda (g) (for/fold ([g g]) ([_ (in-range n)]) (f g)))
                                   (lambda () (list 'expt (value->datum a) n)))
                    a n)]))

;; Powers of one operator are multiplied by adding their exponents.
(define (as-power o base exponent)
  (operator (operator-procedure o) (operator-make-datum o) (cons base exponent)))
(define (base-of o) (if (operator-power o) (car (operator-power o)) o))
(define (exponent-of o) (if (operator-power o) (cdr (operator-power o)) 1))

(define (commutator a b) (g:- (g:* a b) (g:* b a)))
(define (anticommutator a b) (g:+ (g:* a b) (g:* b a)))
