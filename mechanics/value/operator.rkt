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

(provide make-operator operator? operator-procedure
         I-operator commutator anticommutator)

(define kind:operator
  (make-kind #:rank rank:operator
             #:describe (lambda (o) "an operator")
             #:datum (lambda (o) ((operator-make-datum o)))
             #:unary (lambda (op o) (raise-inapplicable op o))
             #:binary (lambda (op a b) (combine-operators op a b))))

;; procedure : function -> function.  make-datum : -> what the operator prints as.
(struct operator (procedure make-datum)
  #:authentic
  #:property prop:kind kind:operator
  #:property prop:procedure (lambda (o . args) (apply-operator o args))
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write (lambda (o port mode) (write-value o port)))

;; The operator of this procedure, printing as `name`.
(define (make-operator procedure name)
  (operator procedure (lambda () name)))

;; The image of a function prints as the application that made it.
(define (apply-operator o args)
  (define image (apply (operator-procedure o) args))
  (if (and (procedure? image) (not (operator? image)) (not (structure? image)))
      (make-function image (arity-mask image)
                     (lambda () (map value->datum (cons o args))))
      image))

(define I-operator (make-operator (lambda (f) f) 'I))

;; ---------------------------------------------------------------------------
;; Algebra

(define (as-operator x)
  (if (operator? x)
      x
      (operator (lambda (f) (g:* x f)) (lambda () (value->datum x)))))

(define (combine-operators op a b)
  (define name (generic-op-name op))
  (case name
    [(+ -) (pointwise op a b)]
    [(*) (product a b)]
    [(/) (if (operator? b) (raise-inapplicable op a b) (product (g:/ 1 b) a))]
    [(expt) (power op a b)]
    [else (raise-inapplicable op a b)]))

(define (pointwise op a b)
  (define combine (generic-op-procedure op))
  (define f (operator-procedure (as-operator a)))
  (define g (operator-procedure (as-operator b)))
  (operator (lambda args (combine (apply f args) (apply g args)))
            (lambda () (list (generic-op-name op) (value->datum a) (value->datum b)))))

(define (product a b)
  (define f (operator-procedure (as-operator a)))
  (define g (operator-procedure (as-operator b)))
  (operator (lambda args (f (apply g args)))
            (lambda () (list '* (value->datum a) (value->datum b)))))

(define (power op a n)
  (unless (and (operator? a) (exact-nonnegative-integer? n))
    (raise-inapplicable op a n))
  (define f (operator-procedure a))
  (operator (lambda (g) (for/fold ([g g]) ([_ (in-range n)]) (f g)))
            (lambda () (case n
                         [(0) 1]
                         [(1) (value->datum a)]
                         [else (list 'expt (value->datum a) n)]))))

(define (commutator a b) (g:- (g:* a b) (g:* b a)))
(define (anticommutator a b) (g:+ (g:* a b) (g:* b a)))
