#lang racket/base
;; Functions as values of the arithmetic.
;;
;; A procedure made by the library (a sum of functions, a derivative) is
;; wrapped together with the S-expression it prints as and its arity; a plain
;; Racket procedure serves as it is.

(require "kind.rkt" "structure.rkt" "describe.rkt")

(provide make-function named-function
         arity-mask accepts? arity->text
         value-at combine-functions compose-unary)

(define kind:function
  (make-kind #:rank rank:function
             #:describe (lambda (f) "a function")
             #:datum (lambda (f) ((function-make-datum f)))
             #:arity (lambda (f) (function-mask f))))

;; mask : what `procedure-arity-mask` would say of the mathematics, which the
;; wrapped procedure's own rest argument does not tell.
(struct function (procedure mask make-datum)
  #:authentic
  #:property prop:procedure 0
  #:property prop:kind kind:function
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write (lambda (f port mode) (write-value f port)))

;; A function that prints as the datum made when it is asked for.
(define (make-function procedure mask make-datum)
  (function procedure mask make-datum))

(define (named-function name procedure)
  (function procedure (procedure-arity-mask procedure) (lambda () name)))

;; ---------------------------------------------------------------------------
;; Arity

(define (arity-mask f)
  (define own (and (has-kind? f) (kind-arity (kind-of f))))
  (cond [own (own f)]
        [(procedure? f) (procedure-arity-mask f)]
        [else -1]))

(define (accepts? f n) (bitwise-bit-set? (arity-mask f) n))

;; 2 -> "2 arguments", 1 or 2 -> "1 or 2 arguments", and so on.
(define (arity->text f)
  (define mask (arity-mask f))
  (define counts
    (for/list ([n (in-range (integer-length mask))] #:when (bitwise-bit-set? mask n)) n))
  (cond [(negative? mask) (format "at least ~a" (counted (integer-length mask)))]
        [(null? counts) "no number of arguments"]
        [(null? (cdr counts)) (counted (car counts))]
        [else (format "~a to ~a" (car counts) (counted (apply max counts)))]))

(define (counted n) (if (= n 1) "1 argument" (format "~a arguments" n)))

;; ---------------------------------------------------------------------------
;; Arithmetic of functions: numbers stand for constant functions, and a tuple
;; for the tuple of the values of its components.

(define (value-at x args)
  (cond [(structure? x) (structure-map (lambda (e) (value-at e args)) x)]
        [(procedure? x) (apply x args)]
        [else x]))

(define (value-at-1 x arg)
  (cond [(structure? x) (structure-map (lambda (e) (value-at-1 e arg)) x)]
        [(procedure? x) (x arg)]
        [else x]))

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
