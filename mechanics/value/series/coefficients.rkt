#lang racket/base
;; Endless sequences, computed when asked for and then remembered.
;;
;; Coefficient k is a function of k, which may ask for other coefficients of the
;; same sequence, lower ones, as recurrences do.  It is computed where it is first
;; needed and nothing marks it as under way: a computation that is interrupted
;; leaves no trace, and when two threads compute the same coefficient one of the
;; two equal values is kept.

(provide make-coefficients coefficients-from coefficients-length coefficients-finite?
         coefficient reader
         factorial)

;; length : from where on all coefficients are exact 0; +inf.0 if they never are
;; known  : a vector of the first coefficients, `unknown` where not yet computed
(struct coefficients (compute length [known #:mutable]) #:authentic)

(define unknown (string->uninterned-symbol "unknown"))

(define (make-coefficients compute [length +inf.0])
  (coefficients compute length (make-vector (if (< length 8) (max length 0) 8) unknown)))

;; The coefficients in a list; all others are 0.
(define (coefficients-from xs)
  (define known (list->vector xs))
  (coefficients (lambda (k) (vector-ref known k)) (vector-length known) known))

(define (coefficients-finite? c) (not (eqv? (coefficients-length c) +inf.0)))

(define (coefficient c k)
  (define known (coefficients-known c))
  (cond [(>= k (coefficients-length c)) 0]
        [(< k (vector-length known))
         (define x (vector-ref known k))
         (if (eq? x unknown) (compute! c k) x)]
        [else (compute! c k)]))

(define (compute! c k)
  (define x ((coefficients-compute c) k))
  (remember! c k x)
  x)

;; A coefficient that another thread stores meanwhile may be lost, to be computed again.
(define (remember! c k x)
  (when (>= k (vector-length (coefficients-known c)))
    (define old (coefficients-known c))
    (define new (make-vector (max (add1 k) (* 2 (vector-length old))) unknown))
    (vector-copy! new 0 old)
    (set-coefficients-known! c new))
  (vector-set! (coefficients-known c) k x))

;; The coefficients as a function of the index.
(define (reader c) (lambda (k) (coefficient c k)))

;; k!, the ratio of a derivative to a Taylor coefficient.
(define (factorial k) (for/product ([j (in-range 1 (add1 k))]) j))
