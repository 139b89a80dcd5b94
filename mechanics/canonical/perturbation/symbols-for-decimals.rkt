#lang racket/base
;; Decimals named: symbols in the place of the decimals of a Hamiltonian.
;;
;; Each order multiplies and divides rounded results of those before, and a sum exactly 0 in
;; theory is 1e-16 in decimals: then nothing is proved, and as exact rationals decimals have so
;; many digits that all is slow.  With a symbol for each of them nothing is rounded, and a result
;; found, and proved, holds for all numbers in their place.  The numbers are put back at the end.
;;
;; Whole numbers written as decimals are counted with, and stay numbers; so do exponents, and
;; factors of an angle within a sine or cosine.

(require "../../algebra/expression/expression.rkt" "../../algebra/expression/operation.rkt"
         "../../algebra/expression/substitute.rkt"
         "../../calculus/expression-function.rkt")

(provide name-decimals with-decimals-named with-decimals-back)

;; es : expressions;  -> ((symbol . positive flonum) ...), each decimal once
(define (name-decimals es)
  (define names (make-hash))
  (define (name! x)
    (hash-ref! names x (lambda () (string->uninterned-symbol (number->string x)))))
  (for ([e (in-list es)]) (rename e name!))
  (sort (for/list ([(x name) (in-hash names)]) (cons name x)) < #:key cdr))

(define (with-decimals-named e decimals)
  (define names (for/hash ([d (in-list decimals)]) (values (cdr d) (car d))))
  (rename e (lambda (x) (hash-ref names x))))

(define (with-decimals-back e decimals)
  (if (null? decimals) e (evaluate-generically e decimals)))

;; ---------------------------------------------------------------------------

;; name : positive flonum -> symbol
(define (rename e name)
  (node-fold e
             (lambda (leaf) (rename-leaf leaf name))
             (lambda (n parts)
               (define head (node-head n))
               (define args (node-args n))
               (cond [(eq? head op:expt) (rebuild head (list (car parts) (whole (cadr args))))]
                     [(memq head (list op:sin op:cos))
                      (rebuild head (list (rename-phase (car args) name)))]
                     [else (rebuild head parts)]))))

(define (rename-leaf leaf name)
  (define x (whole leaf))
  (cond [(not (and (flonum? x) (rational? x))) x]
        [(negative? x) (e:negate (name (- x)))]
        [else (name x)]))

;; The argument of a sine or cosine: its summands that are decimals
(define (rename-phase e name)
  (cond [(and (node? e) (memq (node-head e) (list op:+ op:-)))
         (rebuild (node-head e) (for/list ([part (in-list (node-args e))])
                                  (rename-phase part name)))]
        [(node? e) (with-whole-numbers e)]
        [else (rename-leaf e name)]))

(define (with-whole-numbers e)
  (node-fold e whole (lambda (n parts) (rebuild (node-head n) parts))))

(define (whole x) (if (and (flonum? x) (rational? x) (integer? x)) (inexact->exact x) x))
