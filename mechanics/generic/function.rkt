#lang racket/base
;; Functions as values of the arithmetic.
;;
;; A procedure made by the library (a sum of functions, a derivative) is
;; wrapped together with the S-expression it prints as and its arity; a plain
;; Racket procedure serves as it is.

(require "describe.rkt" "kind.rkt" "up-down.rkt" "value-struct.rkt"
         "../error/complain.rkt" "../error/message-words.rkt")

(provide (struct-out function) make-function unary-function pointwise? of-functions?
         arity-mask accepts? arity->text
         describe-function raise-other-function
         value-at combine-functions compose-unary)

(define kind:function
  (make-kind #:rank rank:function
             #:describe (lambda (f) "a function")
             #:datum (lambda (f) ((function-make-datum f)))
             #:arity function-mask))

;; mask : the arity of the mathematics, as by `procedure-arity-mask`, which the
;; wrapped procedure's own rest argument does not tell.
(value-struct function (procedure mask make-datum)
  #:kind kind:function
  #:property prop:procedure 0)

;; A function that prints as the datum made when it is asked for.
(define (make-function procedure mask make-datum)
  (function procedure mask make-datum))

;; (unary-function make-datum (x) body ...): one of a single argument.  Given another
;; number it says so by the name that it prints as, which Racket does not know.
(define-syntax-rule (unary-function make-datum (x) body0 body ...)
  (let ([name make-datum])
    (make-function (case-lambda [(x) body0 body ...] [xs (raise-takes-one (name) xs)])
                   2
                   name)))

(define (raise-takes-one datum args)
  (complain-of-arity (value->text datum) "takes 1 argument; it was given ~a"
                     (if (null? args) "none" (length args))))

;; Is x a function that arithmetic combines pointwise: neither an operator, nor a
;; tuple of functions?
(define (pointwise? x)
  (and (procedure? x)
       (or (not (has-kind? x)) (eqv? (kind-rank (kind-of x)) rank:function))))

;; Is f a function, or a tuple of functions?
(define (of-functions? f)
  (if (tuple? f)
      (for/and ([part (in-vector (tuple-elements f))]) (of-functions? part))
      (procedure? f)))

;; ---------------------------------------------------------------------------
;; Arity

(define (arity-mask f)
  (define own (and (has-kind? f) (kind-arity (kind-of f))))
  (cond [own (own f)]
        [(structure? f)
         (for/fold ([mask -1]) ([e (in-vector (structure-elements f))])
           (bitwise-and mask (arity-mask e)))]
        [(procedure? f) (procedure-arity-mask f)]
        [else -1]))

(define (accepts? f n) (bitwise-bit-set? (arity-mask f) n))

;; 2 -> "2 arguments", 1 or 2 -> "1 or 2 arguments", and so on.
(define (arity->text f)
  (define mask (arity-mask f))
  (define counts
    (for/list ([n (in-range (integer-length mask))] #:when (bitwise-bit-set? mask n)) n))
  (cond [(negative? mask) (format "at least ~a" (counted (integer-length mask) "argument"))]
        [(null? counts) "no number of arguments"]
        [(null? (cdr counts)) (counted (car counts) "argument")]
        [(null? (cddr counts)) (format "~a or ~a" (car counts) (counted (cadr counts) "argument"))]
        [else (format "~a to ~a" (car counts) (counted (apply max counts) "argument"))]))

;; "the procedure `f`, which takes 2 arguments"; other values as any value
(define (describe-function f)
  (if (pointwise? f)
      (format "~a, which takes ~a" (describe-with-value f) (arity->text f))
      (describe-with-value f)))

;; f is no function, or one of another number of arguments than is expected.
(define (raise-other-function who expected f)
  (complain who "expected ~a\n  given: ~a" expected (describe-function f)))

;; ---------------------------------------------------------------------------
;; Arithmetic of functions: numbers stand for constant functions, and a tuple or
;; matrix for the tuple or matrix of the values of its components.

(define (value-at x args)
  (cond [(pointwise? x) (apply x args)]
        [else (map-leaves (lambda (leaf) (if (procedure? leaf) (apply leaf args) leaf)) x)]))

(define (value-at-1 x arg)
  (cond [(pointwise? x) (x arg)]
        [else (map-leaves (lambda (leaf) (if (procedure? leaf) (leaf arg) leaf)) x)]))

(define (combine-functions op f g)
  (define combine (generic-op-procedure op))
  (make-function
   (case-lambda
     [(x) (combine (value-at-1 f x) (value-at-1 g x))]
     [xs (combine (value-at f xs) (value-at g xs))])
   (bitwise-and (arity-mask f) (arity-mask g))
   (lambda () (list (generic-op-name op) (value->datum f) (value->datum g)))))

(define (compose-unary op f)
  (define outer (generic-op-procedure op))
  (make-function
   (case-lambda
     [(x) (outer (f x))]
     [xs (outer (apply f xs))])
   (arity-mask f)
   (lambda () (list (generic-op-name op) (value->datum f)))))
