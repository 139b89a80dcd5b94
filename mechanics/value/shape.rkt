#lang racket/base
;; Structures as their scalars in a row, of numbers as flvectors; and back.

(require racket/flonum
         "../algebra/expression/constant-value.rkt" "../algebra/expression/expression.rkt"
         "../generic/kind.rkt" "../generic/up-down.rkt")

(provide scalars numeric? shape-length scalars->structure unknowns-like
         structure->flvector flvector->structure vector->structure)

;; The scalars of x, a scalar or a structure of them, from the first to the last.
(define (scalars x)
  (let walk ([x x] [rest '()])
    (if (tuple? x)
        (for/fold ([rest rest]) ([k (in-range (- (structure-length (adopt x)) 1) -1 -1)])
          (walk (vector-ref (tuple-elements x) k) rest))
        (cons x rest))))

;; Is x a number or a structure of numbers, all real?
(define (numeric? x) (andmap real? (scalars x)))

(define (shape-length x) (length (scalars x)))

;; A structure of the shape of x whose k-th scalar is (f k).
(define (scalars->structure x f)
  (define k -1)
  (let walk ([x x])
    (cond [(tuple? x) (structure-map walk (adopt x))]
          [else (set! k (+ k 1))
                (f k)])))

(define (flvector->structure shape v)
  (scalars->structure shape (lambda (k) (flvector-ref v k))))

(define (vector->structure shape v)
  (scalars->structure shape (lambda (k) (vector-ref v k))))

;; A structure of the shape of x, of symbols that stand in no expression; in place of a symbol is
;; one spelt like it, as it may be shown in a message.
(define (unknowns-like x)
  (define names (list->vector (scalars x)))
  (scalars->structure x
                      (lambda (k)
                        (define name (vector-ref names k))
                        (string->uninterned-symbol
                         (if (symbol? name) (symbol->string name) "x")))))

;; Calls (complain scalar) for a scalar that is not a real number; multiples of π are real numbers.
(define (structure->flvector x complain)
  (define xs (scalars x))
  (define v (make-flvector (length xs)))
  (for ([x (in-list xs)] [k (in-naturals)])
    (define r
      (cond [(other-number? x) (comparand x)]
            [(symbolic? x) (constant-value x)]
            [else x]))
    (flvector-set! v k (if (real? r) (real->double-flonum r) (complain x))))
  v)
