#lang racket/base
;; The angles of an expression: the arguments of its sines and cosines.

(require "root.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt")

(provide angles-of in-angle? angle-of-other-period)

;; Does x stand in a sine or cosine?
(define (in-angle? x e) (and (expression? e) (pair? (angles-of e x))))

;; The arguments of sines and cosines in which x occurs.
(define (angles-of f x) (arguments-of f x (list op:sin op:cos)))

;; An angle in these expressions that does not go round a whole number of times while an
;; unknown in it does once, so that a turn of the one is not a turn of the other; or #f
(define (angle-of-other-period es unknowns A)
  (for*/or ([e (in-list es)] [x (in-list unknowns)] [u (in-list (angles-of e x))])
    (define ab (line u x A))
    (and (not (and ab (exact-integer? (car ab)))) u)))
