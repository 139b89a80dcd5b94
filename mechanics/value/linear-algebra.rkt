#lang racket/base
;; Determinants and linear systems over the generic arithmetic.
;;
;; A matrix here is a vector of rows.  Matrices of numbers are eliminated with
;; partial pivoting.  Entries that are not numbers (expressions, dual numbers,
;; functions) form a ring in which one had better not divide: a pivot may be
;; zero in disguise.  Their determinant is expanded along rows with every minor
;; computed once, n 2ⁿ products, and systems are solved by Cramer's rule, which
;; divides once, by the determinant.

(require "../generic/arithmetic.rkt" "../generic/describe.rkt"
         "../numeric/failure.rkt")

(provide rows-determinant rows-solve rows-solve-each rows-inverse rows-transpose)

(define (entry rows i j) (vector-ref (vector-ref rows i) j))

(define (all-numbers? rows)
  (for*/and ([row (in-vector rows)] [x (in-vector row)]) (number? x)))

(define (rows-transpose rows)
  (define n (if (zero? (vector-length rows)) 0 (vector-length (vector-ref rows 0))))
  (for/vector #:length n ([j (in-range n)])
    (for/vector #:length (vector-length rows) ([row (in-vector rows)])
      (vector-ref row j))))

;; ---------------------------------------------------------------------------
;; Determinants

(define (rows-determinant rows)
  (if (all-numbers? rows)
      (eliminate (copy-rows rows) (lambda (sign reduced) (diagonal-product sign reduced))
                 (lambda () 0))
      (determinant-by-minors rows)))

(define (diagonal-product sign rows)
  (for/fold ([p sign]) ([row (in-vector rows)] [i (in-naturals)])
    (* p (vector-ref row i))))

(define (determinant-by-minors rows)
  ((minors rows) (all-columns (vector-length rows))))

(define (all-columns n) (sub1 (arithmetic-shift 1 n)))
(define (without columns j) (bitwise-and columns (bitwise-not (arithmetic-shift 1 j))))

;; The function whose value at a bit set of columns is the determinant of the
;; last rows, as many as there are columns, in these columns.
(define (minors rows)
  (define n (vector-length rows))
  (define known (make-hasheqv))
  (define (minor i columns)
    (cond [(= i n) 1]
          [(hash-ref known columns #f)]
          [else
           (define d (expand i columns))
           (hash-set! known columns d)
           d]))
  (define (expand i columns)
    (for/fold ([sum 0] [sign 1] #:result sum)
              ([j (in-range (integer-length columns))] #:when (bitwise-bit-set? columns j))
      (define a (entry rows i j))
      (define term (if (eqv? a 0) 0 (g:* a (minor (add1 i) (without columns j)))))
      (values (if (= sign 1) (g:+ sum term) (g:- sum term)) (- sign))))
  (lambda (columns) (minor 0 columns)))

;; ---------------------------------------------------------------------------
;; Systems

;; The vector x with rows · x = b; raises exn:fail:mechanics:singular.
(define (rows-solve who rows b)
  (if (and (all-numbers? rows) (for/and ([x (in-vector b)]) (number? x)))
      (solve-by-elimination who rows b)
      (solve-by-Cramer who rows b)))

(define (solve-by-elimination who rows b)
  (define n (vector-length rows))
  (define augmented
    (for/vector #:length n ([row (in-vector rows)] [x (in-vector b)])
      (list->vector (append (vector->list row) (list x)))))
  (eliminate augmented
             (lambda (sign reduced) (substitute-back reduced n))
             (lambda () (raise-singular-system who rows))))

(define (substitute-back rows n)
  (define x (make-vector n 0))
  (for ([i (in-range (sub1 n) -1 -1)])
    (define known
      (for/fold ([s (entry rows i n)]) ([j (in-range (add1 i) n)])
        (- s (* (entry rows i j) (vector-ref x j)))))
    (vector-set! x i (/ known (entry rows i i))))
  x)

(define (solve-by-Cramer who rows b [d (nonzero-determinant who rows)])
  (for/vector #:length (vector-length b) ([j (in-range (vector-length b))])
    (g:/ (determinant-by-minors (replace-column rows j b)) d)))

(define (nonzero-determinant who rows)
  (define d (determinant-by-minors rows))
  (when (and (number? d) (zero? d)) (raise-singular-system who rows))
  d)

(define (replace-column rows j b)
  (for/vector #:length (vector-length rows) ([row (in-vector rows)] [x (in-vector b)])
    (define new (copy row))
    (vector-set! new j x)
    new))

;; The solutions for several right-hand sides, a vector of vectors.
(define (rows-solve-each who rows bs)
  (define d (if (all-numbers? rows) #f (nonzero-determinant who rows)))
  (for/vector #:length (vector-length bs) ([b (in-vector bs)])
    (if d (solve-by-Cramer who rows b d) (rows-solve who rows b))))

;; The rows of the inverse; where the entries are not numbers, cofactors over the
;; determinant, those of one row from one table of minors.
(define (rows-inverse who rows)
  (define n (vector-length rows))
  (if (all-numbers? rows)
      (rows-transpose (rows-solve-each who rows (unit-rows n)))
      (inverse-by-cofactors rows (nonzero-determinant who rows))))

(define (unit-rows n)
  (for/vector #:length n ([i (in-range n)])
    (for/vector #:length n ([j (in-range n)]) (if (= i j) 1 0))))

(define (inverse-by-cofactors rows d)
  (define n (vector-length rows))
  (define all (all-columns n))
  (rows-transpose
   (for/vector #:length n ([i (in-range n)])
     (define minor (minors (without-row rows i)))
     (for/vector #:length n ([j (in-range n)])
       (define m (minor (without all j)))
       (g:/ (if (even? (+ i j)) m (g:- m)) d)))))

(define (without-row rows i)
  (for/vector ([row (in-vector rows)] [k (in-naturals)] #:unless (= k i)) row))

(define (raise-singular-system who rows)
  (raise-singular
   who
   (format "the matrix has no inverse\n  matrix: ~a"
           (for/list ([row (in-vector rows)]) (map value->datum (vector->list row))))
   rows))

;; ---------------------------------------------------------------------------
;; Elimination

;; Reduces rows (which it may change) to upper triangular form with the largest
;; pivots, and passes the sign of the permutation and the rows to `done`; calls
;; `singular` where no pivot is left.
(define (eliminate rows done singular)
  (define n (vector-length rows))
  (let loop ([k 0] [sign 1])
    (cond [(= k n) (done sign rows)]
          [else
           (define p (pivot-row rows k))
           (cond [(not p) (singular)]
                 [else
                  (exchange! rows k p)
                  (clear-below! rows k)
                  (loop (add1 k) (if (= p k) sign (- sign)))])])))

(define (pivot-row rows k)
  (for/fold ([best #f] [size 0] #:result best)
            ([i (in-range k (vector-length rows))])
    (define m (magnitude (entry rows i k)))
    (if (> m size) (values i m) (values best size))))

(define (exchange! rows i j)
  (define row (vector-ref rows i))
  (vector-set! rows i (vector-ref rows j))
  (vector-set! rows j row))

(define (clear-below! rows k)
  (define top (vector-ref rows k))
  (define pivot (vector-ref top k))
  (for ([i (in-range (add1 k) (vector-length rows))])
    (define row (vector-ref rows i))
    (define factor (/ (vector-ref row k) pivot))
    (for ([j (in-range k (vector-length row))])
      (vector-set! row j (- (vector-ref row j) (* factor (vector-ref top j)))))))

(define (copy-rows rows) (for/vector ([row (in-vector rows)]) (copy row)))

(define (copy v)
  (define new (make-vector (vector-length v)))
  (vector-copy! new 0 v)
  new)
