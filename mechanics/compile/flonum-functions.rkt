#lang racket/base
;; The operations of the algebra as functions of flonums, for what compiled code calls.

(require racket/flonum
         racket/list
         "../algebra/expression/operation.rkt"
         "../operation/column.rkt")

(provide flonum-functions flonum-body unsafe-name)

;; body : a function of flonums; name : of Racket's primitive that does the same untested
(struct primitive (body name) #:authentic)

(define-column primitives
  [sqrt (primitive flsqrt 'unsafe-flsqrt)]
  [exp (primitive flexp 'unsafe-flexp)]
  [log (primitive fllog 'unsafe-fllog)]
  [expt (primitive flexpt 'unsafe-flexpt)]
  [abs (primitive flabs 'unsafe-flabs)]
  [sin (primitive flsin 'unsafe-flsin)]
  [cos (primitive flcos 'unsafe-flcos)]
  [tan (primitive fltan 'unsafe-fltan)]
  [asin (primitive flasin 'unsafe-flasin)]
  [acos (primitive flacos 'unsafe-flacos)]
  [atan (primitive flatan 'unsafe-flatan)]
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

(define (primitive-for name arguments) (hash-ref primitives (operation-key name arguments) #f))

;; The name of the primitive for the operation on so many arguments, or #f.
(define (unsafe-name name arguments)
  (define p (primitive-for name arguments))
  (and p (primitive-name p)))

;; The operation on so many arguments, as the compiler has it.
(define (flonum-body name arguments)
  (define p (primitive-for name arguments))
  (cond [p (primitive-body p)]
        [(eq? name 'wrapped) (flonum-function wrap)]
        [else (flonum-function (operation-numeric (find-operation name)))]))
