#lang racket/base
;; The derivatives of a program's values by its inputs, as another program.
;;
;; Every value of the program gets a row of derivatives, an operand for each input; most are
;; the number 0, and cost nothing.  What derivatives have in common with the program, and
;; with each other, is done once: the same builder numbers all values.

(require (only-in racket/list index-of)
         "program-builder.rkt" "program.rkt" "derivative-sweep.rkt")

(provide tangent-program jacobian-program)

;; -> program whose values are the derivatives of the first value by all inputs, then those of
;; the second one ...
(define (tangent-program p)
  (define n (program-inputs p))
  (define-values (b rows) (differentiate p n +inf.0))
  (builder->program b n (for*/list ([r (in-vector rows)] [x (in-vector r)]) x)))

;; -> program whose values are the derivatives of all values by the first of the first n inputs,
;; then those by the second one ..., which is how implicit methods take them; or #f where not all
;; operations have derivatives, or where it would take more operations than `most`
(define (jacobian-program p n #:most [most +inf.0])
  (define-values (b rows) (if (has-derivatives? p) (differentiate p n most) (values #f #f)))
  (and b
       (builder->program b (program-inputs p)
                         (for*/list ([j (in-range n)] [r (in-vector rows)]) (vector-ref r j)))))

;; -> a builder that holds them, and for each output its derivatives by the first n inputs, a
;; vector of operands; #f and #f where that takes too many operations
(define (differentiate p n most)
  (define inputs (program-inputs p))
  (define count (+ inputs (program-length p)))
  (define b (make-builder inputs real->double-flonum))
  (define values-of (make-vector count #f))     ; places of p -> operands of b
  (define rows (make-vector count #f))          ; places of p -> vectors of operands
  (define none (make-vector n 0))
  (define (value x) (if (place? x) (vector-ref values-of (place-index x)) x))
  (define (row x) (if (place? x) (vector-ref rows (place-index x)) none))
  (for ([k (in-range inputs)])
    (vector-set! values-of k (place k))
    (vector-set! rows k (if (< k n) (build-vector n (lambda (j) (if (= j k) 1 0))) none)))
  (for ([i (in-vector (program-instructions p))] [k (in-naturals inputs)]
        #:break (> (written-count b) most))
    (define-values (v r) (differentiated b i value row none))
    (vector-set! values-of k v)
    (vector-set! rows k r))
  (if (> (written-count b) most)
      (values #f #f)
      (values b (for/vector ([o (in-vector (program-outputs p))]) (row o)))))

;; none : the row of what depends on no input
;; -> the operand of the instruction's value, and the row of its derivatives; of a system the
;; operands of its solution, and a row for each
(define (differentiated b i value row none)
  (define operation (instruction-operation i))
  (define xs (map value (instruction-operands i)))
  (define rows (map row (instruction-operands i)))
  (case operation
    [(solve) (differentiate-system b xs rows (vector-length none))]
    [(component) (let ([k (cadr (instruction-operands i))])
                   (values (vector-ref (car xs) k) (vector-ref (car rows) k)))]
    [else
     (define v (again b operation xs))
     (define constant? (for/and ([r (in-list rows)]) (eq? r none)))
     (values v (if constant? none (chain b operation xs v rows)))]))

;; The derivatives of an operation's value, by those of its operands.
(define (chain b operation xs v rows)
  (define i (cons operation xs))
  (for/vector #:length (vector-length (car rows)) ([j (in-range (vector-length (car rows)))])
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
