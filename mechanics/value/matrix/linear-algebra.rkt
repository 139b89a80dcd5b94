#lang racket/base
;; Linear algebra on matrices and on structures that stand for linear maps.
;;
;; A tuple of tuples A is a linear map by the product (* A x); contraction runs
;; over the outer index, so that the components of A are the columns of its
;; matrix when A is seen as acting on tuples x (SICM p. 516 and 5.2.2).

(require "matrix.rkt"
         "../shape.rkt" "../structure.rkt"
         "../../error/complain.rkt" "../../error/hint.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt" "../../generic/dispatch.rkt"
         "../../generic/function.rkt" "../../generic/kind.rkt" "../../generic/on-demand.rkt"
         "../../generic/scalar.rkt" "../../generic/sums-and-products.rkt"
         "../../generic/up-down.rkt" "../../generic/wrong-argument.rkt"
         (only-in "../../numeric/linear-algebra/row-matrix.rkt" rows-transpose))

(require-on-demand
 ["row-systems.rkt" rows-determinant rows-null-space rows-rank rows-solve rows-solve-each])

(provide transpose determinant trace
         solve-linear-left solve-linear-right
         rank null-space
         s->m m->s s:inverse
         ;; for other properties of square matrices
         square-entries)

;; ---------------------------------------------------------------------------
;; Square things

(define (determinant m)
  (define rows (square-entries 'determinant m))
  (if rows (rows-determinant rows) (of-scalar-or-function generic:determinant m)))

(define (trace m)
  (define rows (square-entries 'trace m))
  (if rows (diagonal-sum rows) (of-scalar-or-function generic:trace m)))

;; The rows of a square matrix or tuple of tuples; #f for anything else.
(define (square-entries who m)
  (cond [(matrix? m) (square-rows who m)]
        [(tuple? m) (tuple-rows who m)]
        [else #f]))

(define (diagonal-sum rows)
  (g:for/sum ([row (in-vector rows)] [i (in-naturals)])
    (vector-ref row i)))

;; x is a scalar, a matrix of one entry, or a function, composed with op.
(define (of-scalar-or-function op x)
  (cond [(scalar? x) x]
        [(pointwise? x) (compose-unary op x)]
        [else (raise-inapplicable op x)]))

(define generic:determinant (operation-by-values 'determinant determinant))
(define generic:trace (operation-by-values 'trace trace))

;; The rows of the square matrix that a tuple of tuples holds: one row, the
;; scalars in order, for each component.  Nested deeper, it is a tuple of tuples
;; in some shape of index, as a mass matrix is for the coordinates of several
;; particles: the components are then of the first shape that makes it square.
(define (tuple-rows who s)
  (check-tuple-of-tuples who s)
  (define rows (square-parts s))
  (if rows
      (for/vector ([row (in-list rows)]) (scalar-vector row))
      (complain-showing
       who "expected as many components in each component as there are components"
       "structure" s)))

(define (square-parts s)
  (let try ([like (s:ref s 0)])
    (and (tuple? like)
         (let ([parts (parts-of-shape s like)])
           (if (and parts (= (length parts) (s:dimension like)))
               parts
               (and (positive? (s:length like)) (try (s:ref like 0))))))))

;; The parts of A that are of one shape, in order, where A is a nest of these;
;; #f if it is not.
(define (parts-of-shape A like)
  (cond [(same-shape? A like) (list A)]
        [(tuple? A)
         (for/fold ([parts '()]) ([x (in-vector (tuple-elements A))])
           #:break (not parts)
           (define more (parts-of-shape x like))
           (and more (append parts more)))]
        [else #f]))

(define (scalar-vector s) (list->vector (scalars s)))

(define (check-tuple-of-tuples who s)
  (define elements (structure-elements (structure-of who s)))
  (unless (and (positive? (vector-length elements)) (for/and ([x (in-vector elements)]) (tuple? x)))
    (complain-of-argument who "a tuple of tuples" s)))

;; ---------------------------------------------------------------------------
;; Transposition

;; Of a matrix; of a tuple of scalars, whose orientation changes; of a tuple of tuples,
;; whose two orientations exchange places with their indices; and, with a typical right
;; multiplicand rs, of a structure ms seen as the matrix of rs ↦ (* ms rs) (SICM p. 351).
(define transpose
  (case-lambda
    [(m)
     (cond [(matrix? m) (matrix (rows-transpose (matrix-rows m)))]
           [(tuple? m) (transpose-tuple (adopt m))]
           [else (of-scalar-or-function generic:transpose m)])]
    [(ms rs)
     (define ls (compatible-shape (g:* ms rs)))
     (m->s rs (transpose (s->m ls ms rs)) ls)]))

(define generic:transpose (operation-by-values 'transpose (lambda (m) (transpose m))))

(define (transpose-tuple s)
  (define elements (structure-elements s))
  (if (and (positive? (vector-length elements))
           (not (for/or ([x (in-vector elements)]) (tuple? x))))
      (flip-outer s)
      (transpose-nested s)))

(define (transpose-nested s)
  (check-tuple-of-tuples 'transpose s)
  (define rows
    (for/vector ([x (in-vector (structure-elements s))]) (tuple-elements x)))
  (define inner (adopt (s:ref s 0)))
  (unless (for/and ([row (in-vector rows)])
            (and (= (vector-length row) (structure-length inner))
                 (for/and ([x (in-vector row)]) (not (tuple? x)))))
    (complain 'transpose
              (string-append
               "expected components of one length that hold scalars; given ~a"
               "\n  the transpose of a deeper structure depends on what it multiplies:"
               " (transpose s x)")
              (describe-with-value s)))
  (structure (structure-orientation inner)
             (for/vector ([row (in-vector (rows-transpose rows))])
               (same-orientation s row))))

;; ---------------------------------------------------------------------------
;; Linear systems

;; x such that (* A x) is b.
(define (solve-linear-left A b)
  (define who 'solve-linear-left)
  (cond [(or (pointwise? A) (pointwise? b)) (combine-functions generic:solve-left A b)]
        [(matrix? A)
         (define rows (square-rows who A))
         (cond [(and (up? b) (= (s:length b) (m:num-rows A)))
                (structure 'up (rows-solve who A rows (tuple-elements b)))]
               [(and (matrix? b) (= (m:num-rows b) (m:num-rows A)))
                (matrix (rows-transpose
                         (rows-solve-each who A rows (rows-transpose (matrix-rows b)))))]
               [else (raise-right-hand-side who "an up tuple or a matrix of ~a rows" A b)])]
        [(tuple? A) (solve-by-outer-index who (adopt A) b)]
        [else (solve-one who A b)]))

;; x such that (* x A) is b.
(define (solve-linear-right b A)
  (define who 'solve-linear-right)
  (cond [(or (pointwise? A) (pointwise? b)) (combine-functions generic:solve-right b A)]
        [(matrix? A)
         (define rows (rows-transpose (square-rows who A)))
         (cond [(and (down? b) (= (s:length b) (m:num-cols A)))
                (down-of (rows-solve who A rows (structure-elements b) down-of))]
               [(and (matrix? b) (= (m:num-cols b) (m:num-cols A)))
                (matrix (rows-solve-each who A rows (matrix-rows b) down-of))]
               [else (raise-right-hand-side who "a down tuple or a matrix of ~a columns" A b)])]
        [(not (tuple? A)) (solve-one who A b)]
        [(eq? (s:same A) (innermost-orientation A)) (solve-by-outer-index who (adopt A) b)]
        [else (solve-by-inner-index who (adopt A) b)]))

;; Functions are solved for by their values (SICM p. 71).
(define generic:solve-left (operation-by-values 'solve-linear-left solve-linear-left))
(define generic:solve-right (operation-by-values 'solve-linear-right solve-linear-right))

(define (solve-one who A b)
  (define (only v) (vector-ref v 0))
  (if (and (scalar? A) (scalar? b))
      (only (rows-solve who A (vector (vector A)) (vector b) only))
      (g:/ b A)))

(define (raise-right-hand-side who expected A b)
  (complain who "the right-hand side must be ~a, to match ~a; given ~a~a"
            (format expected (m:num-rows A)) (value->text A) (describe-with-value b)
            (list-hint b)))

(define (innermost-orientation s)
  (define first (and (positive? (s:length s)) (s:ref s 0)))
  (if (tuple? first) (innermost-orientation first) (s:same s)))

;; Σᵢ xᵢ Aᵢ = b, the x of orientation opposite to A's: A is a nest of parts of
;; the shape of b, the columns, and x is nested as they are.
(define (solve-by-outer-index who A b)
  (check-tuple-of-tuples who A)
  (define columns (parts-of-shape A b))
  (unless (and columns (tuple? b)) (raise-mismatch who A (s:ref A 0) b))
  (solve-columns who (map scalar-vector columns) (scalar-vector b) A (part-places A b)))

;; The shape of the unknown that multiplies A, with 0 for each part of A of the shape of `like`:
;; it is nested as A is outside of these parts.
(define (part-places A like)
  (let place ([part A])
    (if (same-shape? part like) 0 (structure-map place (flip-outer part)))))

(define (flip-outer s)
  (structure (flip-orientation (s:same s)) (structure-elements (adopt s))))

;; Σⱼ Aᵢⱼ xⱼ = bᵢ, the x of orientation opposite to that of A's components: for
;; each scalar of b there is a part of A, a row, and x is shaped as those are.
(define (solve-by-inner-index who A b)
  (check-tuple-of-tuples who A)
  (define parts (parts-at-scalars A b))
  (unless (and parts (tuple? b) (for/and ([p (in-list parts)]) (same-shape? p (car parts))))
    (raise-mismatch who A A b))
  (define rows (list->vector (map scalar-vector parts)))
  (solve-columns who (vector->list (rows-transpose rows)) (scalar-vector b) A (flip (car parts))))

;; The parts of A that lie where b has its scalars, in order; #f if A is not
;; nested as b is.
(define (parts-at-scalars A b)
  (cond [(not (tuple? b)) (list A)]
        [(and (tuple? A) (compatible? (adopt A) (adopt b)))
         (for/fold ([parts '()])
                   ([x (in-vector (tuple-elements A))]
                    [y (in-vector (tuple-elements b))])
           #:break (not parts)
           (define more (parts-at-scalars x y))
           (and more (append parts more)))]
        [else #f]))

;; The unknowns, shaped like `like`.
(define (solve-columns who columns b A like)
  (define n (length columns))
  (unless (= n (vector-length b))
    (complain-showing who
                      (string-append
                       (if (> n (vector-length b))
                           "there are more unknowns than equations: the system is under"
                           "there are more equations than unknowns: the system is over")
                       "determined")
                      "unknowns" n "equations" (vector-length b)
                      "structure" A))
  (define (shape v) (vector->structure like v))
  (shape (rows-solve who A (rows-transpose (list->vector columns)) b shape)))

(define (raise-mismatch who A like b)
  (complain who "the right-hand side must be ~a, to match ~a; given ~a"
            (describe (adopt like)) (value->text A) (describe-with-value b)))

;; ---------------------------------------------------------------------------
;; Rank and null space

;; How many rows, or columns, are independent.
(define (rank A)
  (define-values (rows shape) (rows-and-shape 'rank A))
  (rows-rank 'rank A rows))

;; A basis of the x for which (* A x) is zero: a list.
(define (null-space A)
  (define-values (rows shape) (rows-and-shape 'null-space A))
  (map shape (rows-null-space 'null-space A rows)))

;; The matrix of x ↦ (* A x), and a procedure that makes an x of its components.
(define (rows-and-shape who A)
  (cond [(matrix? A) (values (matrix-rows A) (lambda (v) (structure 'up v)))]
        [(and (tuple? A) (nested-parts who (adopt A)))
         => (lambda (parts)
              (define like (part-places (adopt A) (car parts)))
              (values (rows-transpose (list->vector (map scalar-vector parts)))
                      (lambda (v) (vector->structure like v))))]
        [(scalar? A) (values (vector (vector A)) (lambda (v) (vector-ref v 0)))]
        [else (complain-of-argument who "a matrix or a tuple of tuples" A)]))

;; The columns of A: its components, or if those that make it square lie deeper, these.
(define (nested-parts who A)
  (check-tuple-of-tuples who A)
  (or (square-parts A)
      (parts-of-shape A (s:ref A 0))
      (complain-of-argument who "components of one shape" A)))

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
  (scalars->structure
   (flip rs)
   (lambda (j) (scalars->structure (flip ls) (lambda (i) (matrix-ref m i j))))))

;; The structures like s with one scalar 1 and all others 0, in order.
(define (units s)
  (for/list ([k (in-range (s:dimension s))]) (unit-structure s k)))

;; The structure undoing rs ↦ (* ms rs).
(define (s:inverse ls ms rs)
  (m->s (flip rs) (m:invert (s->m ls ms rs)) (flip ls)))
