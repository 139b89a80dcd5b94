#lang racket/base
;; The derivatives of a program's values by its inputs, as another program.
;;
;; Every value of the program gets a row of derivatives, an operand for each input; most are
;; the number 0, and cost nothing.  What derivatives have in common with the program, and
;; with each other, is done once: the same builder numbers all values.

(require "builder.rkt" "program.rkt")

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
     (define slopes (slopes-of b operation xs v))
     (values v (chain b slopes rows n))]))

;; The sum of the slopes by each operand times the derivatives of it.
(define (chain b slopes rows n)
  (for/vector #:length n ([j (in-range n)])
    (for/fold ([sum 0]) ([s (in-list slopes)] [r (in-list rows)])
      (define x (vector-ref r j))
      (if (eqv? x 0) sum (add! b sum (multiply! b (s) x))))))

(define (again b operation xs)
  (case operation
    [(add) (apply add! b xs)]
    [(subtract) (apply subtract! b xs)]
    [(multiply) (apply multiply! b xs)]
    [(divide) (apply divide! b xs)]
    [(negate) (subtract! b 0 (car xs))]
    [else (apply do! b operation xs)]))

;; Thunks, one for each operand: what is not asked for is not written.
(define (slopes-of b operation xs v)
  (define x (car xs))
  (define y (and (pair? (cdr xs)) (cadr xs)))
  (define (call name . operands) (apply do! b name operands))
  (define (square z) (multiply! b z z))
  (define (reciprocal z) (divide! b 1 z))
  (define (root z) (call 'sqrt z))
  (define-syntax-rule (by formula ...) (list (lambda () formula) ...))
  (case operation
    [(add) (by 1 1)]
    [(subtract) (by 1 -1)]
    [(multiply) (by y x)]
    [(divide) (by (reciprocal y) (subtract! b 0 (divide! b v y)))]
    [(negate) (by -1)]
    [(sqrt) (by (divide! b 1/2 v))]
    [(exp) (by v)]
    [(log) (by (reciprocal x))]
    [(sin) (by (call 'cos x))]
    [(cos) (by (subtract! b 0 (call 'sin x)))]
    [(tan) (by (add! b 1 (square v)))]
    [(asin) (by (reciprocal (root (subtract! b 1 (square x)))))]
    [(acos) (by (divide! b -1 (root (subtract! b 1 (square x)))))]
    [(atan)
     (if y
         (let ([r2 (lambda () (add! b (square x) (square y)))])
           (by (divide! b y (r2)) (subtract! b 0 (divide! b x (r2)))))
         (by (reciprocal (add! b 1 (square x)))))]
    [(sinh) (by (call 'cosh x))]
    [(cosh) (by (call 'sinh x))]
    [(tanh) (by (subtract! b 1 (square v)))]
    [(asinh) (by (reciprocal (root (add! b 1 (square x)))))]
    [(acosh) (by (reciprocal (root (subtract! b (square x) 1))))]
    [(atanh) (by (reciprocal (subtract! b 1 (square x))))]
    [(abs) (by (call 'sgn x))]
    [(sgn) (by 0)]
    [(expt) (by (multiply! b y (power! b x (if (number? y) (- y 1) (subtract! b y 1))))
                (multiply! b v (call 'log x)))]
    [(wrapped) (by 1 0 0 0)]))

;; A x = b gives A x' = b' − A' x: another system with the same matrix for each input by which
;; anything in it varies.
(define (differentiate-system b xs rows n)
  (define size (integer-sqrt (length xs)))
  (define width (+ size 1))
  (define entries (list->vector xs))
  (define slopes (list->vector rows))
  (define (entry i j) (vector-ref entries (+ (* i width) j)))
  (define (slope i j k) (vector-ref (vector-ref slopes (+ (* i width) j)) k))
  (define x (solution! b xs size))
  (define (varied k)
    (define right
      (for/list ([i (in-range size)])
        (for/fold ([sum (slope i size k)]) ([j (in-range size)])
          (subtract! b sum (multiply! b (slope i j k) (vector-ref x j))))))
    (if (andmap (lambda (r) (eqv? r 0)) right)
        (make-vector size 0)
        (solution! b
                   (for*/list ([(r i) (in-indexed right)] [j (in-range width)])
                     (if (= j size) r (entry i j)))
                   size)))
  (define columns (for/vector #:length n ([k (in-range n)]) (varied k)))
  (values x
          (for/vector #:length size ([i (in-range size)])
            (for/vector #:length n ([c (in-vector columns)]) (vector-ref c i)))))

(define (in-indexed xs) (in-parallel xs (in-naturals)))

;; -> vector of the places of the unknowns
(define (solution! b entries size)
  (define system (apply do! b 'solve entries))
  (for/vector #:length size ([k (in-range size)]) (write! b (list 'component system k))))
