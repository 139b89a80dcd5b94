#lang racket/base
;; The operations of the algebra as functions of flonums, for what compiled code calls.

(require racket/flonum
         racket/list
         "../algebra/expression/operation.rkt")

(provide flonum-functions flonum-body)

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

;; That of so many arguments, as the compiler has it.
(define (flonum-body name arguments)
  (case name
    [(sin) flsin]
    [(cos) flcos]
    [(sqrt) flsqrt]
    [(exp) flexp]
    [(log) fllog]
    [(tan) fltan]
    [(asin) flasin]
    [(acos) flacos]
    [(abs) flabs]
    [(expt) flexpt]
    [(atan) (if (= arguments 1) flatan (of-table name))]
    [(wrapped) (flonum-function wrap)]
    [else (of-table name)]))

(define (of-table name)
  (flonum-function
   (operation-numeric
    (for/first ([op (in-list operations)] #:when (eq? name (operation-name op))) op))))
