#lang racket/base
;; A basis of the lattice that given vectors span over the integers.
;;
;; The angles θ, θ/2 and θ - φ are vectors over the atoms θ, φ.  To write the
;; sine of each by few sines and cosines one needs vectors b₁ ... bᵣ,
;; independent over the rationals, of which every angle is an *integer*
;; combination: here θ/2 and φ.
;;
;; First a maximal independent subset of the vectors themselves is kept, the
;; earlier ones preferred.  When all others are integer combinations of it (the
;; usual case) it is the basis.  Otherwise a finer lattice will do: fractions of
;; the atoms themselves, if there are no more atoms than dimensions, and else
;; the result of the Hermite normal form of all coordinates, scaled to integers.
;;
;; A vector is a list of (key . rational), keys ascending, rationals nonzero.

(require racket/list)

(provide integer-basis modest-basis modest-basis/atoms integer-combination
         vector-scale vector-add coordinate)

;; vectors -> (values basis coordinates), coordinates a list with, for each
;; vector, a list of (basis position . integer).
(define (integer-basis vectors)
  (define-values (independent coordinates) (rational-basis vectors))
  (define keys (all-keys independent))
  (cond [(andmap integral? coordinates) (values independent coordinates)]
        [(= (length keys) (length independent)) (atomic-basis keys vectors)]
        [else (refine independent coordinates)]))

;; The same with no coordinate above `limit`: vectors whose ratios are not that
;; simple (2.1 and 2.2, read as the binary fractions they are, or 60 and 1) are
;; kept apart, as if nothing related them.
(define (modest-basis vectors limit)
  (define-values (basis coordinates) (integer-basis vectors))
  (if (modest? coordinates limit)
      (values basis coordinates)
      (basis-by-groups vectors limit)))

;; The same, the vectors of the basis having one atom each: it depends on the multiples
;; of every atom alone, not on the combinations given.
(define (modest-basis/atoms vectors limit)
  (define (parts v) (map list v))
  (define (size part) (abs (cdar part)))
  (define all (sort (remove-duplicates (append-map parts vectors)) < #:key size))
  (define-values (basis coordinates) (modest-basis all limit))
  (define table (for/hash ([part (in-list all)] [c (in-list coordinates)]) (values part c)))
  (values basis
          (for/list ([v (in-list vectors)])
            (append-map (lambda (part) (hash-ref table part)) (parts v)))))

(define (modest? coordinates limit)
  (andmap (lambda (entry) (<= (abs (cdr entry)) limit)) (append* coordinates)))

;; Every vector joins the first group whose basis stays modest with it, or
;; begins a group of its own.
(define (basis-by-groups vectors limit)
  (define groups                        ; each a list of vectors, last one first
    (for/fold ([groups '()]) ([v (in-list vectors)])
      (join v groups limit)))
  (for/fold ([basis '()] [table '()]
             #:result (values basis (for/list ([v (in-list vectors)]) (cdr (assq v table)))))
            ([group (in-list groups)])
    (define members (reverse group))
    (define-values (own coordinates) (integer-basis members))
    (define offset (length basis))
    (values (append basis own)
            (append (for/list ([v (in-list members)] [c (in-list coordinates)])
                      (cons v (for/list ([entry (in-list c)])
                                (cons (+ offset (car entry)) (cdr entry)))))
                    table))))

(define (join v groups limit)
  (cond [(null? groups) (list (list v))]
        [else
         (define bigger (cons v (car groups)))
         (define-values (basis coordinates) (integer-basis (reverse bigger)))
         (if (and (< (length basis) (length bigger)) (modest? coordinates limit))
             (cons bigger (cdr groups))
             (cons (car groups) (join v (cdr groups) limit)))]))

(define (all-keys vectors)
  (sort (remove-duplicates (map car (append* vectors)) eqv?) <))

;; Each key alone, divided by the common denominator of its coordinates.
(define (atomic-basis keys vectors)
  (define divisors
    (for/list ([k (in-list keys)])
      (apply lcm (for/list ([v (in-list vectors)]) (denominator (coordinate v k))))))
  (values (for/list ([k (in-list keys)] [d (in-list divisors)]) (list (cons k (/ 1 d))))
          (for/list ([v (in-list vectors)])
            (for/list ([k (in-list keys)] [d (in-list divisors)] [position (in-naturals)]
                       #:unless (eqv? 0 (coordinate v k)))
              (cons position (* d (coordinate v k)))))))

(define (integral? v) (andmap integer? (map cdr v)))

;; ---------------------------------------------------------------------------
;; Sparse vectors

(define (vector-scale c v)
  (if (eqv? c 0)
      '()
      (for/list ([entry (in-list v)]) (cons (car entry) (* c (cdr entry))))))

(define (vector-add u v)
  (cond [(null? u) v]
        [(null? v) u]
        [(< (caar u) (caar v)) (cons (car u) (vector-add (cdr u) v))]
        [(> (caar u) (caar v)) (cons (car v) (vector-add u (cdr v)))]
        [else
         (define c (+ (cdar u) (cdar v)))
         (define rest (vector-add (cdr u) (cdr v)))
         (if (eqv? c 0) rest (cons (cons (caar u) c) rest))]))

(define (coordinate v key)
  (define entry (assv key v))
  (if entry (cdr entry) 0))

;; v's coordinate at row's first key over that of row
(define (ratio v row) (/ (coordinate v (caar row)) (cdar row)))

;; v - c row
(define (subtract-multiple v c row) (vector-add v (vector-scale (- c) row)))

;; ---------------------------------------------------------------------------
;; Over the rationals

;; Each row is (reduced . combination): a reduced vector and how it is made of
;; the independent vectors, whose positions are the keys of the combination.
(define (rational-basis vectors)
  (define-values (independent rows coordinates)
    (for/fold ([independent '()] [rows '()] [coordinates '()])
              ([v (in-list vectors)])
      (define-values (rest combination) (reduce v rows))
      (cond [(null? rest)
             (values independent rows (cons (vector-scale -1 combination) coordinates))]
            [else
             (define k (length independent))
             (values (cons v independent)
                     (append rows (list (cons rest (vector-add combination (list (cons k 1))))))
                     (cons (list (cons k 1)) coordinates))])))
  (values (reverse independent) (reverse coordinates)))

;; -> v - Σ cᵢ vᵢ with the keys of all rows cleared, and -c.
(define (reduce v rows)
  (for/fold ([v v] [combination '()]) ([row (in-list rows)])
    (define c (ratio v (car row)))
    (values (subtract-multiple v c (car row))
            (subtract-multiple combination c (cdr row)))))

;; ---------------------------------------------------------------------------
;; Over the integers

(define (refine independent coordinates)
  (define scale (apply lcm (map denominator (map cdr (append* coordinates)))))
  (define rows
    (for/list ([row (in-list (hermite (for/list ([v (in-list coordinates)])
                                        (vector-scale scale v))))])
      (vector-scale (/ 1 scale) row)))
  (values (for/list ([row (in-list rows)]) (combine row independent))
          (for/list ([v (in-list coordinates)]) (solve v rows))))

(define (combine row vectors)
  (for/fold ([sum '()]) ([entry (in-list row)])
    (vector-add sum (vector-scale (cdr entry) (list-ref vectors (car entry))))))

;; The echelon rows of an integer matrix, by Euclid's algorithm on columns.
(define (hermite rows)
  (define nonzero (filter pair? rows))
  (cond [(null? nonzero) '()]
        [else
         (define key (apply min (map caar nonzero)))
         (define-values (pivot others) (euclid key nonzero))
         (define below (hermite others))
         (cons (reduce-by pivot below) below)]))

;; The row with its entries above the pivots of the rows below made least.
(define (reduce-by row below)
  (for/fold ([row row]) ([b (in-list below)])
    (subtract-multiple row (round (ratio row b)) b)))

(define (euclid key rows)
  (define (size v) (abs (coordinate v key)))
  (define-values (here elsewhere) (partition (lambda (v) (eqv? (caar v) key)) rows))
  (define pivot (argmin size here))
  (define reduced
    (for/list ([v (in-list here)] #:unless (eq? v pivot))
      (define q (quotient (coordinate v key) (coordinate pivot key)))
      (subtract-multiple v q pivot)))
  (define rest (filter pair? (append reduced elsewhere)))
  (if (ormap (lambda (v) (eqv? (caar v) key)) rest)
      (euclid key (cons pivot rest))
      (values (if (negative? (cdar pivot)) (vector-scale -1 pivot) pivot) rest)))

;; v as a combination of echelon rows.
(define (solve v rows)
  (let loop ([v v] [rows rows] [k 0])
    (cond [(null? rows) '()]
          [else
           (define c (ratio v (car rows)))
           (define rest (loop (subtract-multiple v c (car rows)) (cdr rows) (+ k 1)))
           (if (eqv? c 0) rest (cons (cons k c) rest))])))

;; ---------------------------------------------------------------------------
;; Modulo an integer

;; -> integers mᵢ, one a vector, with target ≡ Σ mᵢ vᵢ modulo q in all `size`
;; coordinates, whose keys are 0, 1 ...; or #f.  Vectors are of integers.
;; Each row of the echelon form is followed by how it is made of the vectors.
(define (integer-combination target vectors size q)
  (define made
    (for/list ([v (in-list vectors)] [i (in-naturals)]) (append v (list (cons (+ size i) 1)))))
  (define moduli (for/list ([k (in-range size)]) (list (cons k q))))
  (define rows
    (filter (lambda (row) (< (caar row) size)) (hermite (append made moduli))))
  (define rest
    (for/fold ([v target]) ([row (in-list rows)])
      (subtract-multiple v (floor (ratio v row)) row)))
  (and (or (null? rest) (>= (caar rest) size))
       (for/list ([i (in-range (length vectors))]) (- (coordinate rest (+ size i))))))
