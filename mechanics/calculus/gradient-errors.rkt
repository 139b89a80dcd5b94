#lang racket/base
;; Messages for misuse of gradient and its kin.

(require "../error/complain.rkt" "../error/hint.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/scalar.rkt"
         "../generic/up-down.rkt"
         "../value/structure.rkt")

(provide raise-not-scalar raise-takes-no-point check-increment check-covector)

;; f returned y where a scalar was wanted.
(define (raise-not-scalar who f y)
  (complain who "needs a function whose value is a scalar; ~a returned ~a~a"
            (function-name f) (describe y)
            (cond [(tuple? y) "\n  for the derivatives of all its scalars use jacobian"]
                  [(procedure? y)
                   "\n  for the derivative of a function that returns functions use D"]
                  [else (list-hint y)])))

(define (function-name f)
  (define text (value->text f))
  (if (equal? text "<function>") "the function" text))

;; f does not take one argument, the point.
(define (raise-takes-no-point who f)
  (complain who "needs a function of one argument, the point; ~a takes ~a\n  ~a"
            (function-name f) (arity->text f)
            "with several arguments, make it a function of the tuple of them"))

;; v must be shaped as the point x is.
(define (check-increment who x v)
  (unless (same-shape? x v)
    (complain who "the vector must be of the shape of the point\n  point: ~a\n  vector: ~a"
              (describe-with-value x) (describe-with-value v))))

;; w must contract with the value y to a scalar.
(define (check-covector who y w)
  (unless (and (same-shape? (flip y) w) (or (tuple? y) (scalar? y)))
    (complain who
              "the covector must contract with the value to a scalar~a\n  value: ~a\n  covector: ~a"
              (if (tuple? y)
                  (format ": ~a goes with ~a" (describe (flip y)) (describe y))
                  "")
              (describe-with-value y) (describe-with-value w))))
