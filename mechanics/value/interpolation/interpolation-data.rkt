#lang racket/base
;; Data to interpolate: values at points of a line, checked.
;;
;; Points are real numbers.  Values are anything that can be added and multiplied by
;; numbers: numbers, symbols, tuples of them.

(require "../../error/complain.rkt"
         "../../generic/compare.rkt" "../../generic/describe.rkt" "../../generic/tracing.rkt"
         "../../generic/up-down.rkt" "../../generic/wrong-argument.rkt"
         "../../numeric/finite-number.rkt")

(provide points values-at check-increasing check-distinct
         location)

;; A list, vector or tuple as a vector.
(define (->vector who what xs)
  (cond [(list? xs) (list->vector xs)]
        [(tuple? xs) (structure-elements (adopt xs))]
        [else (complain who "expected ~a in a list, a vector or a tuple\n  given: ~a" what
                        (describe-with-value xs))]))

(define (points who xs)
  (define v (->vector who "points" xs))
  (when (< (vector-length v) 2)
    (complain who "expected two points or more\n  given: ~a" (vector-length v)))
  (for ([x (in-vector v)])
    (define c (comparand x))
    (unless (finite? c)
      (complain-of-argument who "points that are real numbers" x)))
  v)

(define (values-at who what ys xs)
  (define v (->vector who what ys))
  (unless (= (vector-length v) (vector-length xs))
    (complain-showing who (format "expected as many ~a as points" what)
                      what (vector-length v)
                      "points" (vector-length xs)))
  v)

(define (check-increasing who xs)
  (for ([x (in-vector xs)] [next (in-vector xs 1)] [k (in-naturals 1)])
    (cond [(g:= x next) (raise-same who x)]
          [(g:< next x)
           (complain who "expected points in increasing order\n  point ~a: ~a\n  point ~a: ~a"
                     (- k 1) (value->text x) k (value->text next))])))

(define (check-distinct who xs)
  (for* ([i (in-range (vector-length xs))] [j (in-range i)])
    (when (g:= (vector-ref xs i) (vector-ref xs j)) (raise-same who (vector-ref xs i)))))

(define (raise-same who x)
  (complain who "two points are the same\n  point: ~a" (value->text x)))

;; The real number that x is, or that is being differentiated in x.
(define (location who x)
  (define c (comparand x))
  (cond [(real? c) c]
        [else (look-inside who)
              (raise-no-number who x)]))

(define (raise-no-number who x)
  (complain who "the function of these data takes a real number\n  given: ~a"
            (describe-with-value x)))
