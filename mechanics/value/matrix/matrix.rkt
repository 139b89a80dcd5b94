#lang racket/base
;; Matrices: rectangular arrays with matrix multiplication.
;;
;; A matrix acts on up tuples from the left and on down tuples from the right.
;; Where the book means a matrix, a tuple of tuples is accepted too: the one
;; whose components are the rows.

(require "row-products.rkt"
         "../structure.rkt"
         "../../error/complain.rkt" (only-in "../../error/hint.rkt" quoted-expression?)
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/dispatch.rkt" "../../generic/function.rkt" "../../generic/kind.rkt"
         "../../generic/notation.rkt" "../../generic/on-demand.rkt" "../../generic/up-down.rkt"
         "../../generic/value-struct.rkt" "../../generic/wrong-argument.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt")

(provide
 ;; construction
 matrix? matrix-by-rows matrix-by-columns m:generate identity-matrix
 up->column-matrix down->row-matrix column-matrix->up row-matrix->down
 ;; access
 matrix-ref m:num-rows m:num-cols m:dimension m:nth-row m:nth-col m:submatrix
 ;; for the linear algebra above
 matrix matrix-rows same-size? square-rows m:invert matrix-of-functions?)

(require-on-demand
 ["exponential.rkt" rows-exponential]
 ["row-systems.rkt" rows-inverse rows-solve rows-solve-each])

(define kind:matrix
  (make-kind #:rank rank:matrix
             #:describe (lambda (m) (format "a ~a by ~a matrix" (m:num-rows m) (m:num-cols m)))
             #:datum (lambda (m)
                       (cons 'matrix-by-rows
                             (rows-of m (lambda (row) (cons 'list (map value->datum row))))))
             #:notation (lambda (m see)
                          (tree:grid (rows-of m (lambda (row) (map see row)))))
             #:map (lambda (f m) (matrix-map (lambda (x) (map-leaves f x)) m))
             #:unary (lambda (op m)
                       (case (generic-op-name op)
                         [(exp) (matrix (rows-exponential (square-rows 'exp m)))]
                         [(exact->inexact inexact->exact)
                          (matrix-map (generic-op-procedure op) m)]
                         [else (raise-inapplicable op m)]))
             #:component m:nth-row
             #:arity common-arity
             #:binary combine
             #:same? (lambda (same? a b)
                       (and (same-size? a b)
                            (for*/and ([(row other) (in-parallel (matrix-rows a) (matrix-rows b))]
                                       [(x y) (in-parallel row other)])
                              (same? x y))))
             #:zero? (lambda (m) (all-entries? g:zero? (matrix-rows m)))))

;; f of each row, a list
(define (rows-of m f)
  (for/list ([row (in-vector (matrix-rows m))]) (f (vector->list row))))

(define (common-arity m)
  (for*/fold ([mask -1]) ([row (in-vector (matrix-rows m))] [x (in-vector row)])
    (bitwise-and mask (arity-mask x))))

;; rows : a vector of vectors of one length, never changed
(value-struct matrix (rows)
  #:kind kind:matrix
  #:equal-by matrix-rows
  #:property prop:procedure (lambda (m . arguments) (matrix-map (entry-at m arguments) m)))

(define (matrix-of-functions? m) (all-entries? procedure? (matrix-rows m)))

(define (same-size? m n)
  (and (= (m:num-rows m) (m:num-rows n)) (= (m:num-cols m) (m:num-cols n))))

;; entry -> its value at the arguments
(define ((entry-at m arguments) f)
  (unless (procedure? f)
    (complain 'application
              (string-append "a matrix applies its entries to the arguments, "
                             "but the entry ~a of ~a is not a function")
              (value->text f) (value->text m)))
  (apply f arguments))

;; ---------------------------------------------------------------------------
;; Construction

;; Each row a list or a tuple.
(define (matrix-by-rows . rows)
  (define vectors (for/list ([r (in-list rows)]) (row->vector 'matrix-by-rows r)))
  (check-equal-lengths 'matrix-by-rows vectors)
  (matrix (list->vector vectors)))

(define (matrix-by-columns . columns)
  (define vectors (for/list ([c (in-list columns)]) (row->vector 'matrix-by-columns c)))
  (check-equal-lengths 'matrix-by-columns vectors)
  (matrix (rows-transpose (list->vector vectors))))

(define (row->vector who r)
  (cond [(and (list? r) (ormap quoted-expression? r))
         (complain who
                   (string-append "formulas in a quoted list are not computed; without its quote "
                                  "the row is ~a\n  given: '~s")
                   (as-program (cons 'list r)) r)]
        [(and (list? r) (ormap pair? r))
         (complain-showing
          who (format "each list is an argument of its own: (~a '(1 2) '(3 4))" who) "given" r)]
        [(list? r) (list->vector r)]
        [(tuple? r) (structure-elements (adopt r))]
        [else (complain-of-argument who "a row: a list or a tuple" r)]))

;; The text of a datum as a program that makes it: symbols are quoted, heads of lists are not.
(define (as-program datum)
  (cond [(symbol? datum) (format "'~s" datum)]
        [(pair? datum)
         (format "(~a~a)" (car datum)
                 (apply string-append
                        (map (lambda (d) (format " ~a" (as-program d))) (cdr datum))))]
        [else (format "~s" datum)]))

(define (check-equal-lengths who vectors)
  (when (null? vectors)
    (complain-showing who "a matrix has at least one row"))
  (for ([v (in-list vectors)])
    (unless (= (vector-length v) (vector-length (car vectors)))
      (complain-showing who "the rows of a matrix have one length"
                        "first" (vector->list (car vectors))
                        "another" (vector->list v)))))

(define (m:generate rows columns f)
  (matrix (for/vector #:length rows ([i (in-range rows)])
            (for/vector #:length columns ([j (in-range columns)]) (f i j)))))

(define (identity-matrix n)
  (check-argument 'identity-matrix exact-positive-integer? n "a number of rows, at least 1")
  (matrix (unit-rows n)))

(define (up->column-matrix s)
  (matrix (rows-transpose (vector (structure-elements (structure-of 'up->column-matrix s))))))
(define (down->row-matrix s)
  (matrix (vector (structure-elements (structure-of 'down->row-matrix s)))))
(define (column-matrix->up m)
  (check-matrix 'column-matrix->up m)
  (unless (= 1 (m:num-cols m))
    (complain-showing 'column-matrix->up "expected a matrix of one column" "matrix" m))
  (structure 'up (column m 0)))
(define (row-matrix->down m)
  (check-matrix 'row-matrix->down m)
  (unless (= 1 (m:num-rows m))
    (complain-showing 'row-matrix->down "expected a matrix of one row" "matrix" m))
  (structure 'down (vector-ref (matrix-rows m) 0)))

;; ---------------------------------------------------------------------------
;; Access

(define (m:num-rows m)
  (check-matrix 'm:num-rows m)
  (vector-length (matrix-rows m)))
(define (m:num-cols m)
  (check-matrix 'm:num-cols m)
  (vector-length (vector-ref (matrix-rows m) 0)))

(define (matrix-ref m i j)
  (check-matrix 'matrix-ref m)
  (unless (and (index-below? i (m:num-rows m)) (index-below? j (m:num-cols m)))
    (complain-showing 'matrix-ref "there is no such entry"
                      "row" i "column" j "matrix" m))
  (entry (matrix-rows m) i j))

(define (index-below? i n) (and (exact-nonnegative-integer? i) (< i n)))

(define (check-matrix who m)
  (check-argument who matrix? m "a matrix"))

(define (column m j)
  (for/vector #:length (m:num-rows m) ([row (in-vector (matrix-rows m))]) (vector-ref row j)))

(define (m:nth-row m i)
  (check-index 'm:nth-row "row" i (m:num-rows m) m)
  (structure 'down (vector-ref (matrix-rows m) i)))
(define (m:nth-col m j)
  (check-index 'm:nth-col "column" j (m:num-cols m) m)
  (structure 'up (column m j)))

(define (check-index who what i n m)
  (unless (index-below? i n)
    (complain-showing who (format "there is no such ~a" what) what i "matrix" m)))

;; The number of rows of a square matrix.
(define (m:dimension m) (vector-length (square-rows 'm:dimension m)))

;; The rows from low-row up to but not including high-row, the columns likewise.
(define (m:submatrix m low-row high-row low-column high-column)
  (unless (and (index-below? low-row high-row) (<= high-row (m:num-rows m))
               (index-below? low-column high-column) (<= high-column (m:num-cols m)))
    (complain-showing 'm:submatrix "there is no such part"
                      "rows" (list low-row high-row) "columns" (list low-column high-column)
                      "matrix" m))
  (m:generate (- high-row low-row) (- high-column low-column)
              (lambda (i j) (matrix-ref m (+ low-row i) (+ low-column j)))))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (matrix-map f m) (matrix (rows-map f (matrix-rows m))))

(define (combine op a b)
  (case (generic-op-name op)
    [(+ -) (add-matrices op a b)]
    [(*) (multiply op a b)]
    [(/) (divide op a b)]
    [(expt) (power op a b)]
    [else (raise-inapplicable op a b)]))

;; a / b is the x with x b = a: a system for each row of a, or for a down tuple.
(define (divide op a b)
  (cond [(not (matrix? b))
         (if (tuple? b) (raise-inapplicable op a b) (matrix-map (lambda (x) (g:/ x b)) a))]
        [(and (matrix? a) (= (m:num-cols a) (m:num-cols b)))
         (matrix (rows-solve-each '/ b (divisor-rows b) (matrix-rows a) down-of))]
        [(and (down? a) (= (s:length a) (m:num-cols b)))
         (down-of (rows-solve '/ b (divisor-rows b) (structure-elements a) down-of))]
        [(or (matrix? a) (tuple? a)) (raise-inapplicable op a b)]
        [else (multiply op a (matrix (rows-inverse '/ b (square-rows '/ b))))]))

(define (divisor-rows b) (rows-transpose (square-rows '/ b)))

;; A number added to a square matrix is that multiple of the identity.
(define (add-matrices op a b)
  (define add (generic-op-procedure op))
  (define (as-matrix x other)
    (cond [(matrix? x) x]
          [(and (not (tuple? x)) (= (m:num-rows other) (m:num-cols other)))
           (matrix-map (lambda (e) (g:* x e)) (identity-matrix (m:num-rows other)))]
          [else (raise-no-matrix op a b (if (matrix? a) b a))]))
  (define m (as-matrix a b))
  (define n (as-matrix b a))
  (unless (same-size? m n) (raise-inapplicable op a b))
  (matrix (rows-combine add (matrix-rows m) (matrix-rows n))))

;; s : the operand that is no matrix; of a tuple of tuples it is told how it becomes one.
(define (raise-no-matrix op a b s)
  (define inner (and (tuple? s) (> (s:length s) 0) (s:ref s 0)))
  (if (and inner (tuple? inner))
      (raise-inapplicable-because
       op (format "the matrix of a tuple T of tuples is (s->m ~a T ~a)"
                  (dual-zeros inner) (dual-zeros s))
       a b)
      (raise-inapplicable op a b)))

;; (up x y) -> (down 0 0), a datum
(define (dual-zeros s)
  (cons (if (up? s) 'down 'up) (for/list ([_ (in-range (s:length s))]) 0)))

(define (multiply op a b)
  (cond [(tuple? b) (matrix-times-tuple op a b)]
        [(tuple? a) (tuple-times-matrix op a b)]
        [(not (matrix? a)) (matrix-map (lambda (x) (g:* a x)) b)]
        [(not (matrix? b)) (matrix-map (lambda (x) (g:* x b)) a)]
        [(= (m:num-cols a) (m:num-rows b)) (matrix-product a b)]
        [else (raise-inapplicable op a b)]))

(define (matrix-product a b) (matrix (rows-product (matrix-rows a) (matrix-rows b))))

(define (power op m n)
  (unless (and (matrix? m) (exact-integer? n)) (raise-inapplicable op m n))
  (square-rows 'expt m)
  (cond [(negative? n) (power op (m:invert m) (- n))]
        [(zero? n) (identity-matrix (m:num-rows m))]
        [else (positive-power m n)]))

;; By repeated squaring.
(define (positive-power m n)
  (cond [(= n 1) m]
        [(even? n) (positive-power (matrix-product m m) (quotient n 2))]
        [else (matrix-product (positive-power m (sub1 n)) m)]))

;; A matrix times an up tuple, a down tuple times a matrix.
(define (matrix-times-tuple op m s)
  (unless (and (up? s) (= (m:num-cols m) (s:length s))) (raise-inapplicable op m s))
  (structure 'up (for/vector ([row (in-vector (matrix-rows m))])
                   (sum-of-products row (tuple-elements s)))))

(define (tuple-times-matrix op s m)
  (unless (and (down? s) (= (m:num-rows m) (s:length s))) (raise-inapplicable op s m))
  (structure 'down (for/vector ([j (in-range (m:num-cols m))])
                     (sum-of-products (structure-elements s) (column m j)))))
;; ---------------------------------------------------------------------------
;; Square matrices

(define (square-rows who m)
  (check-matrix who m)
  (unless (= (m:num-rows m) (m:num-cols m))
    (complain-showing who "expected a square matrix" "matrix" m))
  (matrix-rows m))

(define (m:invert m)
  (matrix (rows-inverse 'invert m (square-rows 'invert m))))
