#lang racket/base
;; Minors: determinants and cofactors by expansion along rows, each minor once.
;;
;; Expanding along the first of the remaining rows,
;;
;;     |A| = Σⱼ ± a₁ⱼ |A without row 1, column j|,
;;
;; the minors met are those of the last rows, one for each set of columns: at
;; most n 2ⁿ⁻¹ products instead of n!, and far fewer when there are zeros, as
;; minors nothing leads to are never made (n of them and two more each row for a
;; band of three).  No division, no cancellation: every product ends up in
;; the result, which for entries in many symbols makes this cheaper than any
;; elimination (Gentleman and Johnson 1976).  Cofactors, and determinants with a
;; column exchanged for another, share the minors of those that remain.

(provide (struct-out operations)
         make-minors all-lines cofactor minor-with-column
         expansion-cost)

;; Of a commutative ring in which the numbers 0 and 1 are neutral.
(struct operations (add subtract multiply) #:authentic)

;; Sets of rows and of columns are bits of a number.
(define (all-lines n) (sub1 (arithmetic-shift 1 n)))
(define (line-bit i) (arithmetic-shift 1 i))
(define (without lines i) (bitwise-xor lines (line-bit i)))
(define (first-line lines) (sub1 (integer-length (bitwise-and lines (- lines)))))

(define (exact-zero? x) (eqv? x 0))

;; matrix : vector of rows, of any length
;; -> (rows columns -> the minor): the determinant of those rows and columns,
;; equally many.
(define (make-minors ops matrix)
  (define width (vector-length (vector-ref matrix 0)))
  (define known (make-hash))
  (define (minor rows columns)
    (if (eqv? rows 0)
        1
        (let ([key (bitwise-ior (arithmetic-shift rows width) columns)])
          (hash-ref! known key (lambda () (expand rows columns))))))
  (define (expand rows columns)
    (define i (first-line rows))
    (define row (vector-ref matrix i))
    (define others (without rows i))
    (for/fold ([sum 0] [positive? #t] #:result sum)
              ([j (in-range width)] #:when (bitwise-bit-set? columns j))
      (define a (vector-ref row j))
      (define m (if (exact-zero? a) 0 (minor others (without columns j))))
      (values (if (exact-zero? m) sum (accumulate ops positive? sum a m)) (not positive?))))
  minor)

(define (accumulate ops positive? sum a m)
  (define term ((operations-multiply ops) a m))
  (if positive? ((operations-add ops) sum term) ((operations-subtract ops) sum term)))

;; The cofactor of entry (i j) of an n by n matrix.
(define (cofactor ops minor n i j)
  (define all (all-lines n))
  (define m (minor (without all i) (without all j)))
  (if (even? (+ i j)) m ((operations-subtract ops) 0 m)))

;; The determinant of the first n columns, column k put in the place of column j.
(define (minor-with-column ops minor n j k)
  (define all (all-lines n))
  (define m (minor all (bitwise-ior (without all j) (line-bit k))))
  (if (even? (- n 1 j)) m ((operations-subtract ops) 0 m)))

;; ---------------------------------------------------------------------------
;; The cost, without doing it

;; The products that the determinant of a matrix with these entries takes; #f if
;; more than limit.  entries : list, by row, of lists of columns.
(define (expansion-cost entries limit)
  (define seen (make-hasheqv))
  (let/ec give-up
    (let visit ([rows entries] [columns (all-lines (length entries))] [cost 0])
      (cond [(null? rows) cost]
            [(hash-ref seen columns #f) cost]
            [else
             (hash-set! seen columns #t)
             (for/fold ([cost cost]) ([j (in-list (car rows))]
                                      #:when (bitwise-bit-set? columns j))
               (when (>= cost limit) (give-up #f))
               (visit (cdr rows) (without columns j) (add1 cost)))]))))
