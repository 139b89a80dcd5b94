#lang racket/base
;; Taylor series of functions.
;;
;; f(x + dx) = f(x) + Df(x) dx + D²f(x) dx²/2! + ⋯.  As many coefficients as are
;; asked for are found in one run of f on a truncated Taylor number, of order 3, or
;; 7, 15, … as more are wanted.  The terms for a given dx, which may be a tuple as x
;; may, are the coefficients of ε in f(x + ε dx).

(require "derivative-errors.rkt" "derivative.rkt" "infinitesimal-part.rkt" "Taylor-number.rkt"
         "perturbed-value.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/elementary.rkt"
         "../generic/function.rkt" "../generic/scalar.rkt" "../generic/up-down.rkt"
         "../value/series/coefficients.rkt" "../value/series/series.rkt")

(provide Taylor-series Taylor-series-coefficients)

;; ((Taylor-series f) x) is the power series of f about x, a function of dx;
;; several arguments are taken as one up tuple.
(define (Taylor-series f)
  (unless (procedure? f) (raise-needs-function 'Taylor-series f))
  (define (make-datum) (list 'Taylor-series (value->datum f)))
  (make-function
   (case-lambda
     [(x) (Taylor-series-about f x)]
     [xs (Taylor-series-about (lambda (s) (apply f (vector->list (structure-elements s))))
                              (apply up xs))])
   (bitwise-and (arity-mask f) -2)
   make-datum))

(define (Taylor-series-coefficients f . xs) (apply (Taylor-series f) xs))

(define (Taylor-series-about f x)
  (if (scalar? x)
      (power-series-of (coefficients-along f x 1))
      (power-series-with-terms
       (make-coefficients
        (lambda (k) (g:/ (((g:expt D k) f) x) (factorial k))))
       (lambda (dx) (coefficients-along f x dx)))))

;; The coefficients of ε in f(x + ε dx).
(define (coefficients-along f x dx)
  (define runs (make-coefficients (lambda (i) (run-of-order f x dx (sub1 (expt 2 (+ i 2)))))))
  (make-coefficients
   (lambda (k)
     (if (eqv? k 0)
         (f x)
         ((coefficient runs (max 0 (- (integer-length k) 2))) k)))))

;; k -> coefficient k > 0
(define (run-of-order f x dx n)
  (define tag (fresh-tag))
  (define y (f (displace tag n x dx)))
  (lambda (k) (extract (list 'Taylor-coefficient k) tag (lambda (jet) (jet-coefficient jet k)) y)))

(define (displace tag n x dx)
  (cond [(and (tuple? x) (tuple? dx) (compatible? (adopt x) (adopt dx)))
         (structure-map2 (lambda (a b) (displace tag n a b)) (adopt x) (adopt dx))]
        [(and (scalar? x) (scalar? dx)) (make-jet tag n (vector x dx))]
        [else
         (complain-showing 'Taylor-series "the increment must have the shape of the argument"
                           "argument" x "increment" dx)]))
