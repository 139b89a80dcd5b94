#lang racket/base
;; Eigenvectors of a matrix of decimals that is not symmetric.
;;
;; An eigenvalue alone has one eigenvector, which the matrix A less it maps to 0.  One that is
;; repeated comes as several numbers near one another: by roundings ε if it has as many vectors,
;; by as much as ε^(1/k) if it has fewer.  Their mean is the eigenvalue to some ε in both cases.
;; So eigenvalues are taken together that are apart by no more than roundings change them; if
;; their mean λ is an eigenvalue, it has the vectors that A − λ maps to 0, and if not, those are
;; taken together that lie nearer.
;;
;; A is balanced first, so that the units of its coordinates do not count.

(require racket/flonum
         racket/list
         "eigenvalues.rkt" "matrix.rkt" "row-products.rkt" "unsure-digits.rkt"
         "../structure.rkt"
         "../../generic/describe.rkt"
         (only-in "../../numeric/complex-vector.rkt" conjugate)
         "../../numeric/constants.rkt"
         "../../numeric/linear-algebra/flonum-systems.rkt"
         "../../numeric/linear-algebra/general-eigenvalues.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt")

(provide numeric-eigenvectors)

;; rows : of flonums -> a list of (value vector ...), up tuples of unit length
(define (numeric-eigenvectors rows)
  (define found (spectrum 'eigenvectors (matrix rows)))
  (define-values (balanced scales) (balanced-rows rows))
  (define spaces
    (append-map (lambda (near) (spaces-of balanced near widest))
                (clusters found (greatest-entry balanced) widest)))
  (note-unsure 'eigenvectors
               (for/list ([s (in-list spaces)] #:when (unsure? s spaces scales))
                 (format "the vector of ~a" (value->text (space-value s))))
               "other eigenvalues are near, or the coordinates have unlike units")
  (for/list ([s (in-list spaces)])
    (cons (space-value s) (orthonormal (map (lambda (v) (map * scales v)) (space-vectors s))))))

;; within : about how much roundings change the value; vectors : lists, with 1 as greatest entry
(struct space (value within vectors) #:authentic)

;; Roundings turn a vector by their size over the distance to the next eigenvalue, and by more if
;; its own coordinates have small scales.
(define (unsure? s spaces scales)
  (define turn
    (for/fold ([turn epsilon]) ([other (in-list spaces)] #:unless (eq? s other))
      (define distance (magnitude (- (space-value s) (space-value other))))
      (max turn (/ (+ (space-within s) (space-within other)) (max distance 1e-300)))))
  (for/or ([v (in-list (space-vectors s))])
    (few-digits? (* turn (apply max scales))
                 (apply max (map (lambda (scale x) (* scale (magnitude x))) scales v)))))

;; -> rows, and the scales that make vectors of them vectors of the given ones
(define (balanced-rows rows)
  (define n (vector-length rows))
  (cond [(all-entries? real? rows)
         (define v (rows->flvector rows))
         (define scales (balance! v n))
         (values (for/vector ([i (in-range n)])
                   (for/vector ([x (in-flvector v (* i n) (* (+ i 1) n))]) x))
                 (for/list ([s (in-flvector scales)]) s))]
        [else (values rows (make-list n 1.0))]))

;; ---------------------------------------------------------------------------
;; Eigenvalues that are one

;; By how many roundings eigenvalues may be apart that are one, by how much at most, and how far
;; the mean of those may be from one: relative to the entries.
(define widest 1e3)
(define narrowest 1e-2)
(define far 1e-3)
(define rounding 1e-12)

(define (spaces-of rows near gap)
  (define n (vector-length rows))
  (define size (greatest-entry rows))
  (define (alone x)
    (space (sure-value x) (sure-within x) (take (null-vectors rows (sure-value x) (- n 1) 0.0) 1)))
  (define (together)
    (define mean (mean-of (map sure-value near)))
    (define found (null-vectors rows mean n (* rounding size n)))
    (and (pair? found)
         (andmap (lambda (v) (satisfied? rows mean v)) found)
         (list (space mean (* epsilon size n) found))))
  (define closer (/ gap 10))
  (cond [(or (null? (cdr near)) (< gap narrowest)) (map alone near)]
        [(together)]
        [else (append-map (lambda (part) (spaces-of rows part closer))
                          (clusters near size closer))]))

(define (mean-of near)
  (define mean (/ (apply + near) (length near)))
  (if (<= (abs (imag-part mean)) (* 1e-14 (magnitude mean))) (real-part mean) mean))

;; Lists of values of which each is near another in its list, in the order of the values
(define (clusters found size gap)
  (define (near? i j)
    (define-values (x y) (values (list-ref found i) (list-ref found j)))
    (<= (magnitude (- (sure-value x) (sure-value y)))
        (min (* far size)
             (* gap (+ (sure-within x) (sure-within y) (* epsilon (magnitude (sure-value x))))))))
  (for/list ([group (in-list (joined-groups (length found) near?))])
    (map (lambda (i) (list-ref found i)) group)))

;; ---------------------------------------------------------------------------
;; Vectors

;; A basis of the vectors that rows less value take to 0, if pivots up to `small` count as none,
;; and no more than `most` pivots are sought; lists
(define (null-vectors rows value most small)
  (define n (vector-length rows))
  (define A (rows-combine - rows (unit-rows n value 0)))
  (define-values (rank columns) (eliminate-fully! A most small))
  (for/list ([place (in-range rank n)]) (vector->list (null-vector A columns rank place))))

;; Does the vector, with entries up to 1, satisfy each row, however small the row is?
(define (satisfied? rows value v)
  (define allowed (* rounding (vector-length rows)))
  (for/and ([row (in-vector rows)] [x (in-list v)])
    (<= (magnitude (- (for/sum ([a (in-vector row)] [y (in-list v)]) (* a y)) (* value x)))
        (* allowed (greatest-entry (vector row))))))

(define (orthonormal vs)
  (for/fold ([found '()] #:result (map (lambda (v) (apply up v)) (reverse found)))
            ([v (in-list vs)])
    (define greatest (apply max (map magnitude v)))
    (define rest
      (for/fold ([v (map (lambda (a) (/ a greatest)) v)]) ([w (in-list (append found found))])
        (define c (inner w v))
        (map (lambda (a b) (- a (* c b))) v w)))
    (define size (sqrt (real-part (inner rest rest))))
    (cons (map (lambda (a) (/ a size)) rest) found)))

(define (inner w z) (for/sum ([a (in-list w)] [b (in-list z)]) (* (conjugate a) b)))
