#lang racket/base
;; Elimination in rows (row-matrix.rkt) of numbers of one kind, flonums or bigfloats: the loops
;; are written once, and each kind compiles them with its own arithmetic.

(require "row-matrix.rkt")

(provide define-row-operations)

;; (triangulate! rows too-small?) makes the first n columns of n rows an upper triangle, with the
;;                                greatest entry below as pivot -> the sign of the exchanges,
;;                                or #f at a k-th pivot for which (too-small? pivot k)
;; (clear-below! rows k j start)  subtracts multiples of row k, which is 0 before column
;;                                `start`, from those below, to clear column j there
;; (substitute-back! rows)        of rows whose first n columns are an upper triangle ->
;;                                rows of the unknowns, of which there is one for each column
;;                                more
;;
;; The kind has a zero; `greater?` compares values of (size x).
(define-syntax-rule (define-row-operations (triangulate! clear-below! substitute-back!)
                      zero zero? subtract multiply divide size greater?)
  (begin
    (define (triangulate! rows too-small?)
      (define n (vector-length rows))
      (let loop ([k 0] [sign 1])
        (define p (and (< k n) (greatest-below rows k)))
        (when p (exchange! rows k p))
        (cond [(= k n) sign]
              [(too-small? (entry rows k k) k) #f]
              [else
               (clear-below! rows k k (add1 k))
               (loop (add1 k) (if (= p k) sign (- sign)))])))

    ;; The row, from the k-th on, of the greatest entry in column k.
    (define (greatest-below rows k)
      (for/fold ([best k]) ([i (in-range (add1 k) (vector-length rows))])
        (if (greater? (size (entry rows i k)) (size (entry rows best k))) i best)))

    (define (clear-below! rows k j start)
      (define top (vector-ref rows k))
      (define pivot (vector-ref top j))
      (for ([i (in-range (add1 k) (vector-length rows))])
        (define row (vector-ref rows i))
        (define factor (divide (vector-ref row j) pivot))
        (unless (zero? factor)
          (for ([l (in-range start (vector-length row))])
            (vector-set! row l
                         (subtract (vector-ref row l) (multiply factor (vector-ref top l))))))
        (vector-set! row j zero)))

    ;; From the last row to the first.
    (define (substitute-back! rows)
      (define n (vector-length rows))
      (for ([i (in-range (sub1 n) -1 -1)])
        (define row (vector-ref rows i))
        (for ([l (in-range n (vector-length row))])
          (define rest
            (for/fold ([s (vector-ref row l)]) ([j (in-range (add1 i) n)])
              (subtract s (multiply (vector-ref row j) (entry rows j l)))))
          (vector-set! row l (divide rest (vector-ref row i)))))
      (for/vector #:length n ([row (in-vector rows)])
        (for/vector #:length (- (vector-length row) n) ([x (in-vector row n)]) x)))))
