#lang racket/base
;; A value with its scalars changed, and a function with its values changed so, wherever it is
;; called: in derivatives of the function the change is made in their parts.  Only the tape of a
;; gradient holds earlier values: a function is given symbols in their place, and its value at the
;; symbols is evaluated on the tape.

(require (only-in racket/list append-map)
         "expression-function.rkt" "perturbed-value.rkt" "recorded-number.rkt"
         "../algebra/expression/expression.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/kind.rkt"
         "../value/shape.rkt")

(provide change-values)

;; change : scalar -> scalar, of expressions and numbers
;; datum : function -> the datum of the changed one
;; at-symbols? : is a function always given symbols, so that it does no arithmetic with numbers?
;; other : another value, and a procedure that changes values within -> the same, changed
(define (change-values x change datum [other (lambda (leaf within) leaf)]
                       #:at-symbols? [at-symbols? #f])
  (define (at-leaf leaf)
    (cond [(or (symbolic? leaf) (number? leaf)) (change leaf)]
          [(perturbed? leaf) ((parts-map (parts-of leaf)) within leaf)]
          [(other-number? leaf) leaf]
          [(procedure? leaf) (changed-function leaf within datum at-symbols?)]
          [(pair? leaf) (cons (within (car leaf)) (within (cdr leaf)))]
          [else (other leaf within)]))
  (define (within x) (map-leaves at-leaf x))
  (within x))

;; within : value -> changed value
(define (changed-function f within datum at-symbols?)
  (make-function (lambda args
                   (if (or at-symbols? (ormap recorded? (append-map scalars args)))
                       (value-by-symbols f args within)
                       (within (apply f args))))
                 (arity-mask f)
                 (lambda () (datum f))))

(define (value-by-symbols f args within)
  (define point '())
  (define (symbol-for x)
    (define s (string->uninterned-symbol "x"))
    (set! point (cons (cons s x) point))
    s)
  (define symbols
    (map (lambda (a) (s:map/r symbol-for a)) args))
  (map-leaves (lambda (leaf) (if (symbolic? leaf) (evaluate-generically leaf point) leaf))
              (within (apply f symbols))))
