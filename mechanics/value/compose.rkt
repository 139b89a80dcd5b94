#lang racket/base
;; Composition, the identity, constant functions.

(require "../generic/describe.rkt" "../generic/function.rkt" "../generic/wrong-argument.rkt")

(provide compose identity constant-function
         make-function accepts?)

;; ((compose f g h) x ...) is (f (g (h x ...))).
(define compose
  (case-lambda
    [() identity]
    [(f) (check f) f]
    [(f g) (compose-two f g)]
    [(f . more) (compose-two f (apply compose more))]))

(define (compose-two f g)
  (check f)
  (check g)
  (make-function
   (case-lambda
     [(x) (f (g x))]
     [xs (f (apply g xs))])
   (arity-mask g)
   (lambda () (list 'compose (value->datum f) (value->datum g)))))

(define (check f)
  (check-argument 'compose procedure? f "functions"))

(define (identity x) x)

(define (constant-function value)
  (make-function (lambda args value) -1
                 (lambda () (list 'constant-function (value->datum value)))))
