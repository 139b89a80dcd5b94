#lang racket/base
;; The derivatives of a program's values by its inputs, as another program.
;;
;; Every value of the program gets a row of derivatives, an operand for each input; most are
;; the number 0, and cost nothing.  What derivatives have in common with the program, and
;; with each other, is done once: the same builder numbers all values.

(require (only-in racket/list index-of)
         "builder.rkt" "program.rkt" "sweep.rkt")

(provide tangent-program)

;; -> program whose values are the derivatives of the first value by all inputs, then those of
;; the second one ...
(define (tangent-program p)
  (define n (program-inputs p))
  (define count (+ n (program-length p)))
  (define b (make-builder n real->double-flonum))
  (define values-of (make-vector count #f))     ; places of p -> operands of b
  (define rows (make-vector count #f))          ; places of p -> vectors of operands
  (define (value x) (if (place? x) (vector-ref values-of (place-index x)) x))
  (define (row x) (if (place? x) (vector-ref rows (place-index x)) (make-vector n 0)))
  (for ([k (in-range n)])
    (vector-set! values-of k (place k))
    (vector-set! rows k (build-vector n (lambda (j) (if (= j k) 1 0)))))
  (for ([i (in-vector (program-instructions p))] [k (in-naturals n)])
    (define-values (v r) (differentiated b i value row n))
    (vector-set! values-of k v)
    (vector-set! rows k r))
  (define outputs
    (for*/vector ([o (in-vector (program-outputs p))] [x (in-vector (row o))]) x))
  (builder->program b n (vector->list outputs)))

;; -> the operand of the instruction's value, and the row of its derivatives; of a system the
;; operands of its solution, and a row for each
(define (differentiated b i value row n)
  (define operation (instruction-operation i))
  (define xs (map value (instruction-operands i)))
  (define rows (map row (instruction-operands i)))
  (case operation
    [(solve) (differentiate-system b xs rows n)]
    [(component) (let ([k (cadr (instruction-operands i))])
                   (values (vector-ref (car xs) k) (vector-ref (car rows) k)))]
    [else
     (define v (again b operation xs))
     (values v (chain b operation xs v rows n))]))

;; The derivatives of an operation's value, by those of its operands.
(define (chain b operation xs v rows n)
  (define i (cons operation xs))
  (for/vector #:length n ([j (in-range n)])
    (define ts (for/list ([r (in-list rows)]) (vector-ref r j)))
    (define (tangent operand) (list-ref ts (index-of xs operand)))
    (if (andmap zero-operand? ts)
        0
        (next-tangent b i v (car ts) (if (null? (cdr ts)) 0 (cadr ts)) tangent))))

(define (zero-operand? x) (eqv? x 0))

(define (again b operation xs)
  (case operation
    [(add) (apply add! b xs)]
    [(subtract) (apply subtract! b xs)]
    [(multiply) (apply multiply! b xs)]
    [(divide) (apply divide! b xs)]
    [(negate) (negate! b (car xs))]
    [else (apply do! b operation xs)]))

;; A x = b gives A x' = b' − A' x: another system with the same matrix for each input by which
;; anything in it varies.
(define (differentiate-system b xs rows n)
  (define size (integer-sqrt (length xs)))
  (define width (+ size 1))
  (define entries (list->vector xs))
  (define slopes (list->vector rows))
  (define (entry i j) (vector-ref entries (+ (* i width) j)))
  (define (slope i j k) (vector-ref (vector-ref slopes (+ (* i width) j)) k))
  (define x (list->vector (solve! b xs)))
  (define (varied k)
    (define right
      (for/list ([i (in-range size)])
        (for/fold ([sum (slope i size k)]) ([j (in-range size)])
          (subtract! b sum (multiply! b (slope i j k) (vector-ref x j))))))
    (if (andmap zero-operand? right)
        (make-vector size 0)
        (list->vector
         (solve! b (for*/list ([i (in-range size)] [j (in-range width)])
                     (if (= j size) (list-ref right i) (entry i j)))))))
  (define columns (for/vector #:length n ([k (in-range n)]) (varied k)))
  (values x
          (for/vector #:length size ([i (in-range size)])
            (for/vector #:length n ([c (in-vector columns)]) (vector-ref c i)))))
