#lang racket/base
;; The operations of the algebra as functions of flonums, called by compiled code.

(require racket/flonum
         racket/list
         "../algebra/expression/operation.rkt"
         "../operation/operation-column.rkt")

(provide flonum-functions flonum-body flonum-primitive)

;; Racket's primitives of flonums, each named fl and its operation
(define-column primitives
  [sqrt flsqrt] [exp flexp] [log fllog] [expt flexpt] [abs flabs] [sin flsin] [cos flcos]
  [tan fltan] [asin flasin] [acos flacos] [atan flatan]
  [(atan2 sinh cosh tanh asinh acosh atanh erf sgn) (none "Racket has none of flonums")])

;; Names and functions in turn: the numeric body of each operation, not a number where that
;; is not real.
(define (flonum-functions)
  (append*
   (for/list ([op (in-list operations)])
     (list (operation-name op) (flonum-function (operation-numeric op))))))

;; f is an operation of the algebra, no function of the user's.
(define ((flonum-function f) . xs)
  (define value
    (with-handlers ([exn:fail:contract? (lambda (e) +nan.0)])
      (apply f xs)))
  (if (real? value) (real->double-flonum value) +nan.0))

;; The primitive for an operation of so many arguments, or #f
(define (flonum-primitive name arguments) (hash-ref primitives (operation-key name arguments) #f))

;; The function of so many arguments, as the compiler has it.
(define (flonum-body name arguments)
  (cond [(flonum-primitive name arguments)]
        [(eq? name 'wrapped) (flonum-function wrap)]
        [else (flonum-function (operation-numeric (find-operation name)))]))
