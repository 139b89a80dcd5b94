#lang racket/base
;; The block triangular form of a square matrix, from its zeros alone.
;;
;; Match every row with a column where it has an entry, no column twice.  If
;; some row is left over, the rows reached from it (from a row to the columns of
;; its entries, from a column to the row matched with it) have entries in fewer
;; columns than they are: the matrix is singular whatever its entries are (Hall,
;; König).  Otherwise let row i point to row k if i has an entry in the column
;; of k.  Rows that reach one another form a block; a block needs only itself
;; and blocks it points to.  In that order the blocks stand on the diagonal and
;; all else is below it (Dulmage and Mendelsohn 1958), so a determinant is the
;; product of theirs, a system is solved block after block, and the cost is that
;; of the blocks.
;;
;; Tarjan's algorithm finds the blocks, those pointed to first.

(require racket/list)

(provide (struct-out block) (struct-out deficiency)
         block-triangular-form strong-components permutation-sign)

;; rows, columns : lists of indices, equally many
(struct block (rows columns) #:transparent)

;; rows : more of them than there are columns in which they have entries
(struct deficiency (rows) #:transparent)

;; entries : vector by row of ascending lists of columns -> list of blocks, or a deficiency
(define (block-triangular-form entries)
  (define n (vector-length entries))
  (define owners (make-vector n #f))
  (define unmatched
    (for/or ([i (in-range n)])
      (and (not (match-row! entries owners i)) i)))
  (if unmatched
      (deficiency (reached-rows entries owners unmatched))
      (let ([column-of (inverse-permutation owners)])
        (for/list ([rows (in-list (strong-components (point-to-owners entries owners)))])
          (block rows (sort (for/list ([i (in-list rows)]) (vector-ref column-of i)) <))))))

;; Entries (i i) are dropped, others lead to the row matched with their column.
(define (point-to-owners entries owners)
  (for/vector #:length (vector-length entries) ([columns (in-vector entries)] [i (in-naturals)])
    (for*/list ([j (in-list columns)] [k (in-value (vector-ref owners j))] #:unless (= k i)) k)))

(define (inverse-permutation p)
  (define q (make-vector (vector-length p)))
  (for ([i (in-vector p)] [j (in-naturals)]) (vector-set! q i j))
  q)

;; ---------------------------------------------------------------------------
;; Matching

;; Finds a column for row i, other rows giving way; -> was there one?  The
;; diagonal is tried first: then most rows stay where they are.
(define (match-row! entries owners i)
  (define seen (make-vector (vector-length entries) #f))
  (let match! ([i i])
    (define columns (vector-ref entries i))
    (for/or ([j (in-list (if (memv i columns) (cons i columns) columns))]
             #:unless (vector-ref seen j))
      (vector-set! seen j #t)
      (define owner (vector-ref owners j))
      (and (or (not owner) (match! owner))
           (begin (vector-set! owners j i) #t)))))

(define (reached-rows entries owners start)
  (let loop ([waiting (list start)] [reached '()])
    (cond [(null? waiting) (sort reached <)]
          [(memv (car waiting) reached) (loop (cdr waiting) reached)]
          [else
           (loop (for/fold ([rows (cdr waiting)])
                           ([j (in-list (vector-ref entries (car waiting)))])
                   (cons (vector-ref owners j) rows))
                 (cons (car waiting) reached))])))

;; ---------------------------------------------------------------------------
;; Strong components

;; successors : vector of lists -> list of ascending lists, successors first.
(define (strong-components successors)
  (define n (vector-length successors))
  (define times (make-vector n #f))
  (define low (make-vector n #f))
  (define done (make-vector n #f))
  (define clock 0)
  (define stack '())
  (define components '())
  (define (visit! i)
    (vector-set! times i clock)
    (vector-set! low i clock)
    (set! clock (add1 clock))
    (set! stack (cons i stack))
    (for ([k (in-list (vector-ref successors i))])
      (unless (vector-ref times k) (visit! k))
      (unless (vector-ref done k)
        (vector-set! low i (min (vector-ref low i) (vector-ref low k)))))
    (when (= (vector-ref low i) (vector-ref times i)) (close! i)))
  (define (close! i)
    (let loop ([members '()])
      (define k (car stack))
      (set! stack (cdr stack))
      (vector-set! done k #t)
      (if (= k i)
          (set! components (cons (sort (cons k members) <) components))
          (loop (cons k members)))))
  (for ([i (in-range n)] #:unless (vector-ref times i)) (visit! i))
  (reverse components))

;; ---------------------------------------------------------------------------

;; 1 or -1 for a list of distinct numbers: the parity of its inversions.
(define (permutation-sign xs)
  (let loop ([xs xs] [sign 1])
    (cond [(null? xs) sign]
          [else
           (define inversions (count (lambda (y) (< y (car xs))) (cdr xs)))
           (loop (cdr xs) (if (even? inversions) sign (- sign)))])))
