#lang racket/base
;; Singular values by one-sided Jacobi rotations (Hestenes 1958): pairs of columns are turned
;; until each is orthogonal to all others.  Their lengths are then the singular values, small
;; ones with as many digits as great ones, and the turns together are V: A V = U Σ.
;;
;; A column of length 0, or of roundings only, has no direction of its own: its place in U is
;; taken by any one at right angles to the others, so that U is orthogonal for singular A, too.

(require racket/flonum
         racket/list
         "Jacobi-rotation.rkt" "row-matrix.rkt"
         "../constants.rkt" "../flvector.rkt")

(provide singular-values columns-of)

;; Of a matrix given as a vector of rows of real numbers
(define (columns-of rows)
  (for/list ([column (in-vector (rows-transpose rows))])
    (for/flvector #:length (vector-length column) ([x (in-vector column)])
      (real->double-flonum x))))

;; columns : a list of flvectors, no more of them than entries in each
;; -> lists, by falling singular value, of columns of U, values, and columns of V
(define (singular-values columns)
  (define n (length columns))
  (define turned (for/vector ([c (in-list columns)]) (flvector-copy c)))
  (define turns (build-vector n (lambda (j) (unit-flvector j n))))
  (turn-all-pairs! n (lambda (p q) (turn! turned turns p q)))
  (define order
    (sort (for/list ([u (in-vector turned)] [v (in-vector turns)]) (list (norm u) u v))
          > #:key first))
  (values (directions (map first order) (map second order))
          (map first order)
          (map third order)))

;; Makes columns p and q orthogonal; #f if they are.
(define (turn! columns turns p q)
  (define u (vector-ref columns p))
  (define w (vector-ref columns q))
  (define-values (a b c) (values (dot u u) (dot w w) (dot u w)))
  (define turned? (fl> (flabs c) (fl* (fl* 4.0 epsilon) (fl* (flsqrt a) (flsqrt b)))))
  (when turned?
    (define-values (tangent cosine sine) (rotation (fl/ (fl- b a) (fl* 2.0 c))))
    (for ([i (in-range (flvector-length u))]) (mix! u i w i cosine sine))
    (for ([j (in-range (vector-length turns))])
      (mix! (vector-ref turns p) j (vector-ref turns q) j cosine sine)))
  turned?)

;; ---------------------------------------------------------------------------
;; Columns of unit length, from columns in order of falling length

(define (directions lengths columns)
  (define rounding (fl* (fl* 100.0 epsilon) (first lengths)))
  (for/fold ([found '()] #:result (reverse found))
            ([length (in-list lengths)] [u (in-list columns)])
    (define own (and (fl> length 0.0) (flvector-scaled (fl/ 1.0 length) u)))
    (cons (if (fl> length rounding) own (beside found own (flvector-length u)))
          found)))

;; A unit vector at right angles to those found: the part of `own` that is, if most of it is
(define (beside found own n)
  (define (free u)
    (for/fold ([u u]) ([v (in-list (append found found))]) (along u (- (dot u v)) v)))
  (define candidates (cons own (for/list ([i (in-range n)]) (unit-flvector i n))))
  (define freed (for/list ([u (in-list candidates)] #:when u) (free u)))
  (define best
    (or (and own (fl> (norm (first freed)) 0.9) (first freed)) (argmax norm freed)))
  (flvector-scaled (fl/ 1.0 (norm best)) best))
