#lang racket/base
;; The domain of a question, as prove-zero takes it: all that it speaks of, as expressions.
;;
;; A Lagrangian along a path is evaluated at a state of symbols, and the path is put
;; in then: log(x − 2) stays log(1 − 2), where evaluating gives a complex number.

(require (only-in racket/list append-map)
         "../algebra/expression/expression.rkt" "../algebra/expression/substitute.rkt"
         "../error/refusal.rkt"
         "../generic/irrational.rkt"
         "../value/shape.rkt")

(provide values-at values-along expressions-of)

;; fs : functions, or #f, of a state of symbols -> the scalars of their values there
(define (values-at fs state)
  (append-map (lambda (f) (or (value-at f state) '())) fs))

;; state : the state along a path, or at one place
(define (values-along fs state)
  (define anything (unknowns-like state))
  (define places
    (map cons (scalars anything) (map irrational-as-expression (scalars state))))
  (append-map (lambda (f)
                (define found (value-at f anything))
                (if found
                    (for/list ([e (in-list found)]) (in-place-of places e))
                    (or (value-at f state) '())))
              fs))

;; -> a list, or #f of a function that fails there
(define (value-at f state)
  (and f
       (if-raised raised? #f (expressions-of (f state)))))

(define (expressions-of x) (filter expression? (scalars x)))
