#lang racket/base
;; Eigenvalues of any real matrix of flonums, real and complex, as LAPACK finds them.
;;
;; Three steps, each a similarity, which leaves the eigenvalues where they are.
;; *Balancing* scales coordinates by powers of two, without rounding, until each row is
;; about as long as its column.  *Reflections* then leave nothing below the first
;; subdiagonal (Hessenberg's form).  *Francis's steps* then make the subdiagonal shrink:
;; with σ and σ̄ the eigenvalues of the last two rows, H² - (σ + σ̄) H + σ σ̄ is factored
;; into Q R without being formed (its first column decides Q), and Q* H Q is the next H,
;; real throughout.  The last one or two eigenvalues separate after two or three steps
;; each, and a smaller matrix remains (Francis 1961; Golub and Van Loan, 7.5).
;;
;; An entry below the diagonal counts as zero by the rule of Ahues and Tisseur (LAPACK
;; Working Note 122, 1997), which keeps small eigenvalues beside large ones.

(require racket/flonum
         racket/unsafe/ops
         "../constants.rkt" "../flvector.rkt" (only-in "../unboxed-loop.rkt" unboxed))

(provide real-matrix-eigenvalues balance!)

(define-syntax-rule (at m n i j) (flvector-ref m (+ (* i n) j)))
(define-syntax-rule (put! m n i j x) (flvector-set! m (+ (* i n) j) x))

;; a : flvector of n² finite entries, row by row; it is not changed.
;; -> a list of n numbers, flonums or complex, or #f where they do not separate
(define (real-matrix-eigenvalues a n)
  (define balanced (flvector-copy a))
  (balance! balanced n)
  (define unit (unit-of balanced))
  (define h (in-units balanced unit))
  (to-Hessenberg! h n)
  (define found (separate h n))
  (and found (for/list ([x (in-list found)]) (* unit x))))

;; In units of about the greatest entry products of entries neither overflow nor vanish.  The unit
;; is a power of two, so that nothing is rounded.
(define (unit-of v)
  (define size (greatest v))
  (if (fl= size 0.0)
      1.0
      (flexpt 2.0 (flmin 1023.0 (flfloor (fl/ (fllog size) (fllog 2.0)))))))

(define (in-units v unit) (flvector-map (lambda (x) (fl/ x unit)) v))

;; ------------------------------------------------------------------ balancing

;; Coordinates are scaled while that makes some row and column together shorter by a
;; twentieth: with the diagonal, so that nothing is scaled for the sake of entries that are
;; small beside it (James, Langou and Lowery 2014).
;; -> the scales: a vector of the balanced matrix times them is one of the given matrix
(define (balance! h n)
  (define scales (make-flvector n 1.0))
  (let again ()
    (when (for/fold ([changed? #f]) ([i (in-range n)])
            (or (balance-one! h n i scales) changed?))
      (again)))
  scales)

(define (balance-one! h n i scales)
  (define column (length-along h i n n))
  (define row (length-along h (* i n) 1 n))
  (and (fl< 0.0 column +inf.0)
       (fl< 0.0 row +inf.0)
       (let* ([f (scale-between column row)] [g (fl/ 1.0 f)]
              [scale (fl* f (flvector-ref scales i))])
         (and (fl< (fl+ (fl* column f) (fl* row g)) (fl* 0.95 (fl+ column row)))
              (fl< 1e-290 scale 1e290)
              (for ([j (in-range n)])
                (put! h n i j (fl* (at h n i j) g))
                (put! h n j i (fl* (at h n j i) f)))
              (flvector-set! scales i scale)
              #t))))

;; Of n entries, `stride` apart from place i on, in a unit of which the squares neither overflow
;; nor vanish, if they do.
(define (length-along h i stride n)
  (define (squares unit)
    (let loop ([k 0] [j i] [sum 0.0])
      (if (unsafe-fx= k n)
          (unboxed sum)
          (let ([x (unsafe-fl* unit (unsafe-flvector-ref h j))])
            (loop (unsafe-fx+ k 1) (unsafe-fx+ j stride) (unsafe-fl+ sum (unsafe-fl* x x)))))))
  (define plain (squares 1.0))
  (cond [(fl< 1e-280 plain 1e280) (flsqrt plain)]
        [else
         (define size
           (for/fold ([m 0.0]) ([k (in-range n)])
             (flmax m (flabs (flvector-ref h (+ i (* k stride)))))))
         (define unit
           (flexpt 2.0 (flmin 1000.0 (flfloor (fl/ (fllog size) (fl- 0.0 (fllog 2.0)))))))
         (if (fl< 0.0 size +inf.0) (fl/ (flsqrt (squares unit)) unit) size)]))

;; The power of two nearest to the root of row/column.
(define (scale-between column row)
  (flexpt 2.0 (flround (fl/ (fl- (fllog row) (fllog column)) (fl* 2.0 (fllog 2.0))))))

;; ---------------------------------------------------------------- reflections

;; A reflection for each column m - 1 makes it end at row m.
(define (to-Hessenberg! h n)
  (define v (make-flvector n))
  (for ([m (in-range 1 (- n 1))])
    (define beta (mirror! h n m v))
    (unless (fl= beta 0.0)
      (for ([j (in-range (- m 1) n)]) (reflect-all! h j n m n v beta))
      (for ([i (in-range n)]) (reflect-all! h (* i n) 1 m n v beta))
      (for ([i (in-range (+ m 1) n)]) (put! h n i (- m 1) 0.0)))))

;; Sets v, with 1 at m, so that 1 - β v v* sends the part of column m - 1 from row m on to the
;; first axis.  -> β; 0 if that part lies there
(define (mirror! h n m v)
  (define below (length-along h (+ (* (+ m 1) n) (- m 1)) n (- n m 1)))
  (cond [(fl= below 0.0) 0.0]
        [else
         (define x (at h n m (- m 1)))
         (define size (flmax (flabs x) below))
         (define-values (p q) (values (fl/ x size) (fl/ below size)))
         (define long (fl* size (flsqrt (fl+ (fl* p p) (fl* q q)))))
         (define v0 (if (fl< x 0.0) (fl- x long) (fl+ x long)))
         (flvector-set! v m 1.0)
         (for ([i (in-range (+ m 1) n)]) (flvector-set! v i (fl/ (at h n i (- m 1)) v0)))
         (fl/ (flabs v0) long)]))

;; Entries number m to n - 1 of those that are `stride` apart from place i on.
(define (reflect-all! h i stride m n v beta)
  (define start (+ i (* m stride)))
  (define along
    (let loop ([k m] [j start] [sum 0.0])
      (if (unsafe-fx= k n)
          (unsafe-fl* beta sum)
          (loop (unsafe-fx+ k 1) (unsafe-fx+ j stride)
                (unsafe-fl+ sum (unsafe-fl* (unsafe-flvector-ref v k)
                                            (unsafe-flvector-ref h j)))))))
  (let loop ([k m] [j start])
    (when (unsafe-fx< k n)
      (unsafe-flvector-set! h j (unsafe-fl- (unsafe-flvector-ref h j)
                                            (unsafe-fl* along (unsafe-flvector-ref v k))))
      (loop (unsafe-fx+ k 1) (unsafe-fx+ j stride)))))

;; ------------------------------------------------------------------ separating

;; Rows `first` to `last` are the block that cannot be divided at present; every tenth
;; step that has not divided it takes shifts out of the way of a possible cycle.
(define (separate h n)
  (let loop ([last (- n 1)] [steps 0] [found '()])
    (define first (block-start h n last))
    (cond [(< last 0) found]
          [(= first last) (loop (- last 1) 0 (cons (at h n last last) found))]
          [(= first (- last 1)) (loop (- last 2) 0 (append (last-two h n last) found))]
          [(= steps 300) #f]
          [else (Francis-step! h n first last steps)
                (loop last (+ steps 1) found)])))

;; The row above which the subdiagonal is negligible beside its neighbours.
(define (block-start h n last)
  (let loop ([i last])
    (cond [(<= i 0) 0]
          [(negligible? h n last i)
           (put! h n i (- i 1) 0.0)
           i]
          [else (loop (- i 1))])))

;; Is the entry before the diagonal's in row i?  It is small beside the diagonal, or, where that
;; vanishes, beside the subdiagonal's next ones; and its product with the entry across is small
;; beside the distance of the two eigenvalues.
(define (negligible? h n last i)
  (define k (- i 1))
  (define below (flabs (at h n i k)))
  (define-values (d u) (values (at h n i i) (at h n k k)))
  (define beside
    (let ([sum (fl+ (flabs u) (flabs d))])
      (cond [(fl> sum 0.0) sum]
            [else (fl+ (if (> k 0) (flabs (at h n k (- k 1))) 0.0)
                       (if (< i last) (flabs (at h n (+ i 1) i)) 0.0))])))
  (or (fl<= below smallest)
      (and (fl<= below (fl* epsilon beside))
           (let* ([across (flabs (at h n k i))] [gap (flabs (fl- u d))] [d (flabs d)]
                  [large (flmax d gap)] [small (flmin d gap)]
                  [most (flmax below across)] [size (fl+ large most)])
             (fl<= (fl* (flmin below across) (fl/ most size))
                   (flmax smallest (fl* epsilon (fl* small (fl/ large size)))))))))

;; Beside entries of size 1.
(define smallest 1e-290)

;; The eigenvalues of rows last - 1 and last.
(define (last-two h n last)
  (define k (- last 1))
  (define-values (a b c d)
    (values (at h n k k) (at h n k last) (at h n last k) (at h n last last)))
  (define half (fl/ (fl- a d) 2.0))
  (define size (flmax (flabs half) (flmax (flabs b) (flabs c))))
  (define p (fl/ half size))
  (define square (fl+ (fl* p p) (fl* (fl/ b size) (fl/ c size))))
  (define root (fl* size (flsqrt (flabs square))))
  (cond [(fl= size 0.0) (list a d)]
        [(fl< square 0.0)
         (define re (fl/ (fl+ a d) 2.0))
         (list (make-rectangular re (fl- 0.0 root)) (make-rectangular re root))]
        [else (two-real half root a b c d)]))

;; a + b c/z and d - b c/z, with the z that loses no digits.  The first is d + z, which would lose
;; digits where z is small beside d.
(define (two-real half root a b c d)
  (define z (if (fl< half 0.0) (fl- half root) (fl+ half root)))
  (if (fl= z 0.0)
      (list d d)
      (let ([change (fl* b (fl/ c z))])
        (list (fl+ a change) (fl- d change)))))

;; One step on the block: a reflection of three coordinates makes the first column of
;; the shifted square a multiple of the first axis, and others chase the bulge which it
;; leaves down and out of the matrix.
(define (Francis-step! h n first last steps)
  (define-values (re im) (shift h n first last steps))
  (define-values (start x y z) (start-of-chase h n first last re im))
  (let chase ([k start] [x x] [y y] [z z])
    (define three? (< (+ k 1) last))
    (reflect! h n first last start k x y (if three? z 0.0))
    (when three?
      (chase (+ k 1)
             (at h n (+ k 1) k)
             (at h n (+ k 2) k)
             (if (< (+ k 2) last) (at h n (+ k 3) k) 0.0)))))

;; The pair of shifts re ± i im: the eigenvalues of the last two rows, or twice the one that is
;; nearer to the last entry, if they are real; every tenth step others.
(define (shift h n first last steps)
  (define (unusual i j k)
    (define s (fl+ (flabs (at h n (+ i 1) i)) (flabs (at h n (+ j 1) j))))
    (values (fl+ (fl* 0.75 s) (at h n k k)) (fl* 0.66 s)))
  (case (remainder steps 20)
    [(9) (unusual first (+ first 1) first)]
    [(19) (unusual (- last 1) (- last 2) last)]
    [else
     (define pair (last-two h n last))
     (define-values (u w corner) (values (car pair) (cadr pair) (at h n last last)))
     (cond [(flonum? u)
            (values (if (fl< (flabs (fl- u corner)) (flabs (fl- w corner))) u w) 0.0)]
           [else (values (real-part w) (imag-part w))])]))

;; -> the row where the step may begin, as the subdiagonal before it is so small that with the
;; first column's it makes nothing, and the first column of (H - re)² + im² from there on
(define (start-of-chase h n first last re im)
  (let up ([m (- last 2)])
    (define-values (a b c d)
      (values (at h n m m) (at h n m (+ m 1)) (at h n (+ m 1) m) (at h n (+ m 1) (+ m 1))))
    (define size (fl+ (flabs c) (fl+ (flabs (fl- a re)) (flabs im))))
    (define-values (c* p) (values (fl/ c size) (fl- a re)))
    (define x (fl+ (fl+ (fl* p (fl/ p size)) (fl* im (fl/ im size))) (fl* b c*)))
    (define y (fl* c* (fl+ p (fl- d re))))
    (define z (fl* c* (at h n (+ m 2) (+ m 1))))
    (define (beside i) (flabs (at h n i i)))
    (if (or (= m first)
            (fl<= (fl* (flabs (at h n m (- m 1))) (fl+ (flabs y) (flabs z)))
                  (fl* epsilon (fl* (flabs x) (fl+ (beside (- m 1))
                                                   (fl+ (beside m) (beside (+ m 1))))))))
        (values m x y z)
        (up (- m 1)))))

;; The reflection 1 - β v v* that sends (x y z) to the first axis acts on rows and
;; columns k, k + 1 and k + 2.
(define (reflect! h n first last start k x y z)
  (define size (flmax (flabs x) (flmax (flabs y) (flabs z))))
  (unless (fl= size 0.0)
    (define-values (p q r) (values (fl/ x size) (fl/ y size) (fl/ z size)))
    (define long (flsqrt (fl+ (fl* p p) (fl+ (fl* q q) (fl* r r)))))
    (define v0 (if (fl< p 0.0) (fl- p long) (fl+ p long)))
    (define-values (v1 v2) (values (fl/ q v0) (fl/ r v0)))
    (define beta (fl/ 2.0 (fl+ 1.0 (fl+ (fl* v1 v1) (fl* v2 v2)))))
    (define count (if (< (+ k 1) last) 3 2))
    (for ([j (in-range (max start (- k 1)) (+ last 1))])
      (reflect-three! h (+ (* k n) j) n count beta v1 v2))
    (for ([i (in-range first (+ 1 (min last (+ k 3))))])
      (reflect-three! h (+ (* i n) k) 1 count beta v1 v2))
    (cond [(> k start)
           (put! h n (+ k 1) (- k 1) 0.0)
           (when (= count 3) (put! h n (+ k 2) (- k 1) 0.0))]
          [(> k first) (put! h n k (- k 1) (fl* (at h n k (- k 1)) (fl- 1.0 beta)))])))

;; Two or three entries, `stride` apart from place i on.
(define (reflect-three! h i stride count beta v1 v2)
  (define third (and (= count 3) (+ i stride stride)))
  (define along
    (fl* beta (fl+ (flvector-ref h i)
                   (fl+ (fl* v1 (flvector-ref h (+ i stride)))
                        (if third (fl* v2 (flvector-ref h third)) 0.0)))))
  (flvector-set! h i (fl- (flvector-ref h i) along))
  (flvector-set! h (+ i stride) (fl- (flvector-ref h (+ i stride)) (fl* along v1)))
  (when third
    (flvector-set! h third (fl- (flvector-ref h third) (fl* along v2)))))
