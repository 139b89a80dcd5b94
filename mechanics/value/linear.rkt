#lang racket/base
;; Linear algebra on matrices and on structures that stand for linear maps.
;;
;; A tuple of tuples A is a linear map by the product (* A x); contraction runs
;; over the outer index, so that the components of A are the columns of its
;; matrix when A is seen as acting on tuples x (SICM p. 516 and 5.2.2).

(require "structure.rkt" "matrix.rkt" "linear-algebra.rkt"
         (only-in "signature.rkt" scalar?)
         "../generic/kind.rkt" "../generic/structure.rkt" "../generic/describe.rkt"
         "../generic/function.rkt" "../generic/dispatch.rkt" "../generic/arithmetic.rkt")

(provide transpose determinant trace
         solve-linear-left solve-linear-right
         s->m m->s s:inverse)

;; ---------------------------------------------------------------------------
;; Square things

(define (determinant m)
  (cond [(matrix? m) (rows-determinant (square-rows 'determinant m))]
        [(tuple? m) (rows-determinant (tuple-rows 'determinant m))]
        [else (of-scalar-or-function generic:determinant m)]))

(define (trace m)
  (cond [(matrix? m) (diagonal-sum (square-rows 'trace m))]
        [(tuple? m) (diagonal-sum (tuple-rows 'trace m))]
        [else (of-scalar-or-function generic:trace m)]))

(define (diagonal-sum rows)
  (for/fold ([sum 0]) ([row (in-vector rows)] [i (in-naturals)])
    (g:+ sum (vector-ref row i))))

;; A scalar is a matrix of one entry; a function is taken by its values.
(define (of-scalar-or-function op x)
  (cond [(scalar? x) x]
        [(pointwise? x) (compose-unary op x)]
        [else (raise-inapplicable op x)]))

(define (generic-of-matrices name procedure) (generic-op name #f procedure '() '()))
(define generic:determinant (generic-of-matrices 'determinant determinant))
(define generic:trace (generic-of-matrices 'trace trace))

;; The rows of the square matrix that a tuple of tuples holds: one row, the
;; scalars in order, for each component.  Nested deeper, it is a tuple of tuples
;; in some shape of index, as a mass matrix is for the coordinates of several
;; particles: the components are then of the first shape that makes it square.
(define (tuple-rows who s)
  (check-tuple-of-tuples who s)
  (or (let try ([like (s:ref s 0)])
        (and (tuple? like)
             (let ([rows (parts-of-shape s like)])
               (if (and rows (= (length rows) (s:dimension like)))
                   (for/vector ([row (in-list rows)]) (scalars row))
                   (and (positive? (s:length like)) (try (s:ref like 0)))))))
      (raise-arguments-error who "expected as many components in each component as there are components"
                             "structure" s)))

;; The parts of A that are of one shape, in order, where A is a nest of these;
;; #f if it is not.
(define (parts-of-shape A like)
  (cond [(same-shape? A like) (list A)]
        [(tuple? A)
         (for/fold ([parts '()]) ([x (in-vector (structure-elements (adopt A)))])
           #:break (not parts)
           (define more (parts-of-shape x like))
           (and more (append parts more)))]
        [else #f]))

;; The scalars of a tuple, at any depth, as a vector.
(define (scalars s) (list->vector (reverse (s:fold cons '() s))))

(define (check-tuple-of-tuples who s)
  (define elements (structure-elements (structure-of who s)))
  (unless (and (positive? (vector-length elements)) (for/and ([x (in-vector elements)]) (tuple? x)))
    (complain "~a: expected a tuple of tuples; given ~a" who (describe-with-value s))))

(define (complain format-string . args)
  (raise (exn:fail:contract (apply format format-string args) (current-continuation-marks))))

;; ---------------------------------------------------------------------------
;; Transposition

;; Of a matrix; of a tuple of tuples, whose two orientations exchange places
;; with their indices; and, with a typical right multiplicand rs, of a structure
;; ms seen as the matrix of rs ↦ (* ms rs) (SICM p. 351).
(define transpose
  (case-lambda
    [(m)
     (cond [(matrix? m) (matrix (rows-transpose (matrix-rows m)))]
           [(tuple? m) (transpose-tuple (adopt m))]
           [else (of-scalar-or-function generic:transpose m)])]
    [(ms rs)
     (define ls (compatible-shape (g:* ms rs)))
     (m->s rs (transpose (s->m ls ms rs)) ls)]))

(define generic:transpose (generic-of-matrices 'transpose (lambda (m) (transpose m))))

(define (transpose-tuple s)
  (check-tuple-of-tuples 'transpose s)
  (define rows
    (for/vector ([x (in-vector (structure-elements s))]) (structure-elements (adopt x))))
  (define inner (adopt (s:ref s 0)))
  (unless (for/and ([row (in-vector rows)])
            (and (= (vector-length row) (structure-length inner))
                 (for/and ([x (in-vector row)]) (not (tuple? x)))))
    (complain "~a: expected components of one length that hold scalars; given ~a\n  the transpose of a deeper structure depends on what it multiplies: (transpose s x)"
              'transpose (describe-with-value s)))
  (structure (structure-orientation inner)
             (for/vector ([row (in-vector (rows-transpose rows))])
               (same-orientation s row))))

;; ---------------------------------------------------------------------------
;; Linear systems

;; x such that (* A x) is b.
(define (solve-linear-left A b)
  (define who 'solve-linear-left)
  (cond [(matrix? A)
         (define rows (square-rows who A))
         (cond [(and (up? b) (= (s:length b) (m:num-rows A)))
                (structure 'up (rows-solve who rows (structure-elements (adopt b))))]
               [(and (matrix? b) (= (m:num-rows b) (m:num-rows A)))
                (matrix (rows-transpose
                         (rows-solve-each who rows (rows-transpose (matrix-rows b)))))]
               [else (raise-right-hand-side who "an up tuple or a matrix of ~a rows" A b)])]
        [(tuple? A) (solve-by-outer-index who (adopt A) b)]
        [else (g:/ b A)]))

;; x such that (* x A) is b.
(define (solve-linear-right b A)
  (define who 'solve-linear-right)
  (cond [(matrix? A)
         (define rows (rows-transpose (square-rows who A)))
         (cond [(and (down? b) (= (s:length b) (m:num-cols A)))
                (structure 'down (rows-solve who rows (structure-elements b)))]
               [(and (matrix? b) (= (m:num-cols b) (m:num-cols A)))
                (matrix (rows-solve-each who rows (matrix-rows b)))]
               [else (raise-right-hand-side who "a down tuple or a matrix of ~a columns" A b)])]
        [(not (tuple? A)) (g:/ b A)]
        [(eq? (s:same A) (innermost-orientation A)) (solve-by-outer-index who (adopt A) b)]
        [else (solve-by-inner-index who (adopt A) b)]))

(define (raise-right-hand-side who expected A b)
  (complain "~a: the right-hand side must be ~a, to match ~a; given ~a~a"
            who (format expected (m:num-rows A)) (value->text A) (describe-with-value b)
            (if (pair? b) "\n  a list is not a tuple; use (up x y ...)" "")))

(define (innermost-orientation s)
  (define first (and (positive? (s:length s)) (s:ref s 0)))
  (if (tuple? first) (innermost-orientation first) (s:same s)))

;; Σᵢ xᵢ Aᵢ = b, the x of orientation opposite to A's: A is a nest of parts of
;; the shape of b, the columns, and x is nested as they are.
(define (solve-by-outer-index who A b)
  (check-tuple-of-tuples who A)
  (define columns (parts-of-shape A b))
  (unless (and columns (tuple? b)) (raise-mismatch who A (s:ref A 0) b))
  (define x (solve-columns who (map scalars columns) (scalars b) A))
  (fill (let shape ([part A]) (if (same-shape? part b) 0 (structure-map shape (flip-outer part)))) x))

(define (flip-outer s)
  (structure (flip-orientation (s:same s)) (structure-elements (adopt s))))

;; Σⱼ Aᵢⱼ xⱼ = bᵢ, the x of orientation opposite to that of A's components: for
;; each scalar of b there is a part of A, a row, and x is shaped as those are.
(define (solve-by-inner-index who A b)
  (check-tuple-of-tuples who A)
  (define parts (parts-at-scalars A b))
  (unless (and parts (tuple? b) (for/and ([p (in-list parts)]) (same-shape? p (car parts))))
    (raise-mismatch who A A b))
  (define rows (list->vector (map scalars parts)))
  (define x (solve-columns who (vector->list (rows-transpose rows)) (scalars b) A))
  (fill (flip (car parts)) x))

;; The parts of A that lie where b has its scalars, in order; #f if A is not
;; nested as b is.
(define (parts-at-scalars A b)
  (cond [(not (tuple? b)) (list A)]
        [(and (tuple? A) (compatible? (adopt A) (adopt b)))
         (for/fold ([parts '()])
                   ([x (in-vector (structure-elements (adopt A)))]
                    [y (in-vector (structure-elements (adopt b)))])
           #:break (not parts)
           (define more (parts-at-scalars x y))
           (and more (append parts more)))]
        [else #f]))

(define (solve-columns who columns b A)
  (unless (= (length columns) (vector-length b))
    (raise-arguments-error who "there are not as many unknowns as equations"
                           "unknowns" (length columns) "equations" (vector-length b)
                           "structure" A))
  (rows-solve who (rows-transpose (list->vector columns)) b))

;; A structure shaped like `like` with these scalars, in order.
(define (fill like v)
  (define k -1)
  (s:map/r (lambda (_) (set! k (add1 k)) (vector-ref v k)) like))

(define (raise-mismatch who A like b)
  (complain "~a: the right-hand side must be ~a, to match ~a; given ~a"
            who (describe (adopt like)) (value->text A) (describe-with-value b)))

;; ---------------------------------------------------------------------------
;; Structures as matrices (SICM p. 353)

;; The matrix of the bilinear form (* ls (* ms rs)) in the scalars of ls and rs.
(define (s->m ls ms rs)
  (define lefts (units ls))
  (define rights (units rs))
  (matrix
   (for/vector ([l (in-list lefts)])
     (for/vector ([r (in-list rights)])
       (g:* l (g:* ms r))))))

;; The structure whose bilinear form on ls and rs has this matrix.
(define (m->s ls m rs)
  (define j -1)
  (s:map/r (lambda (_)
             (set! j (add1 j))
             (define column j)
             (define i -1)
             (s:map/r (lambda (_) (set! i (add1 i)) (matrix-ref m i column)) (flip ls)))
           (flip rs)))

;; The structures like s with one scalar 1 and all others 0, in order.
(define (units s)
  (for/list ([k (in-range (s:dimension s))])
    (define n -1)
    (s:map/r (lambda (_) (set! n (add1 n)) (if (= n k) 1 0)) s)))

;; The structure undoing rs ↦ (* ms rs).
(define (s:inverse ls ms rs)
  (m->s (flip rs) (m:invert (s->m ls ms rs)) (flip ls)))
