#lang racket/base
;; Work that is done once for all values of a shape.

(require "assumptions.rkt"
         "../generic/up-down.rkt")

(provide by-shape)

;; value : (f x); shape : x; declared : the assumptions under which it was found
(struct result (value shape declared) #:authentic)

;; -> a procedure of x that gives (f x).  It calls f anew if x is of another shape than at the last
;; call, or other assumptions are declared, unless the value is lasting?, which holds under any.
;; Two threads may both call f.
(define (by-shape f #:lasting? [lasting? (lambda (value) #f)])
  (define latest #f)
  (define (holds? r x)
    (and (same-shape? x (result-shape r))
         (or (lasting? (result-value r)) (equal? (result-declared r) (assumptions 'declared)))))
  (lambda (x)
    (define r latest)
    (cond [(and r (holds? r x)) (result-value r)]
          [else
           (define value (f x))
           (set! latest (result value x (assumptions 'declared)))
           value])))
