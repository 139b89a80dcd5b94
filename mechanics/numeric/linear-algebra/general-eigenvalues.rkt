#lang racket/base
;; Eigenvalues of any real matrix of flonums, real and complex.
;;
;; Three steps, each a similarity, which leaves the eigenvalues where they are.
;; *Balancing* scales coordinates by powers of two, without rounding, until each row is
;; about as long as its column.  *Elimination* leaves nothing below the first
;; subdiagonal (Hessenberg's form).  *Francis's steps* then make the subdiagonal shrink:
;; with σ and σ̄ the eigenvalues of the last two rows, H² - (σ + σ̄) H + σ σ̄ is factored
;; into Q R without being formed (its first column decides Q), and Q* H Q is the next H,
;; real throughout.  The last one or two eigenvalues separate after two or three steps
;; each, and what remains is a smaller matrix (Francis 1961; Golub and Van Loan, 7.5).

(require racket/flonum
         "matrix-scaling.rkt"
         "../constants.rkt" "../flvector.rkt")

(provide real-matrix-eigenvalues)

(define-syntax-rule (at m n i j) (flvector-ref m (+ (* i n) j)))
(define-syntax-rule (put! m n i j x) (flvector-set! m (+ (* i n) j) x))

;; a : flvector of n² finite entries, row by row; it is not changed.
;; -> a list of n numbers, flonums or complex, or #f where they do not separate
(define (real-matrix-eigenvalues a n)
  (define unit (unit-of a))
  (define h (in-units a unit))
  (balance! h n)
  (to-Hessenberg! h n)
  (define found (separate h n))
  (and found (for/list ([x (in-list found)]) (* unit x))))

;; ------------------------------------------------------------------ balancing

;; Coordinates are scaled while that makes some row and column together shorter by a
;; twentieth.
(define (balance! h n)
  (let again ()
    (when (for/fold ([changed? #f]) ([i (in-range n)])
            (or (balance-one! h n i) changed?))
      (again))))

(define (balance-one! h n i)
  (define-values (c r)
    (for/fold ([c 0.0] [r 0.0]) ([j (in-range n)] #:unless (= j i))
      (values (fl+ c (flabs (at h n j i))) (fl+ r (flabs (at h n i j))))))
  (and (< 0.0 c +inf.0)
       (< 0.0 r +inf.0)
       (let ([f (scale-between c r)])
         (and (fl< (fl+ (fl* c f) (fl/ r f)) (fl* 0.95 (fl+ c r)))
              (for ([j (in-range n)])
                (put! h n i j (fl/ (at h n i j) f))
                (put! h n j i (fl* (at h n j i) f))
                #t)
              #t))))

;; The power of two nearest to the root of r/c.
(define (scale-between c r)
  (flexpt 2.0 (flround (fl/ (fllog (fl/ r c)) (fl* 2.0 (fllog 2.0))))))

;; ---------------------------------------------------------------- elimination

;; Multiples of one row are taken from those below it, and of their columns added to
;; its own, with the greatest entry as pivot.
(define (to-Hessenberg! h n)
  (for ([m (in-range 1 (- n 1))])
    (define p
      (for/fold ([best m]) ([i (in-range (+ m 1) n)])
        (if (fl> (flabs (at h n i (- m 1))) (flabs (at h n best (- m 1)))) i best)))
    (unless (= p m) (exchange! h n p m))
    (define pivot (at h n m (- m 1)))
    (unless (fl= pivot 0.0)
      (for ([i (in-range (+ m 1) n)])
        (clear! h n i m (fl/ (at h n i (- m 1)) pivot))))))

(define (exchange! h n p m)
  (for ([j (in-range n)]) (flvector-swap! h (+ (* p n) j) (+ (* m n) j)))
  (for ([j (in-range n)]) (flvector-swap! h (+ (* j n) p) (+ (* j n) m))))

(define (clear! h n i m factor)
  (unless (fl= factor 0.0)
    (for ([j (in-range n)])
      (put! h n i j (fl- (at h n i j) (fl* factor (at h n m j)))))
    (for ([j (in-range n)])
      (put! h n j m (fl+ (at h n j m) (fl* factor (at h n j i)))))
    (put! h n i (- m 1) 0.0)))

;; ------------------------------------------------------------------ separating

;; Rows `first` to `last` are the block that cannot be divided at present; every tenth
;; step that has not divided it takes shifts out of the way of a possible cycle.
(define (separate h n)
  (let loop ([last (- n 1)] [steps 0] [found '()])
    (define first (block-start h n last))
    (cond [(< last 0) found]
          [(= first last) (loop (- last 1) 0 (cons (at h n last last) found))]
          [(= first (- last 1)) (loop (- last 2) 0 (append (last-two h n last) found))]
          [(= steps 100) #f]
          [else (Francis-step! h n first last (and (= 9 (remainder steps 10))))
                (loop last (+ steps 1) found)])))

;; The row above which the subdiagonal is negligible beside its neighbours.
(define (block-start h n last)
  (let loop ([i last])
    (cond [(<= i 0) 0]
          [(negligible? (at h n i (- i 1)) (at h n i i) (at h n (- i 1) (- i 1)))
           (put! h n i (- i 1) 0.0)
           i]
          [else (loop (- i 1))])))

(define (negligible? x a b)
  (define size (fl+ (flabs a) (flabs b)))
  (fl<= (flabs x) (fl* (fl* 0.5 epsilon) (if (fl= size 0.0) 1.0 size))))

;; The eigenvalues of rows last - 1 and last.
(define (last-two h n last)
  (define k (- last 1))
  (define-values (a b c d)
    (values (at h n k k) (at h n k last) (at h n last k) (at h n last last)))
  (define half (fl/ (fl- a d) 2.0))
  (define square (fl+ (fl* half half) (fl* b c)))
  (cond [(fl< square 0.0)
         (define re (fl/ (fl+ a d) 2.0))
         (define im (flsqrt (flabs square)))
         (list (make-rectangular re (fl- 0.0 im)) (make-rectangular re im))]
        [else (two-real half square a b c d)]))

;; a + b c/z and d - b c/z, with the z that loses no digits.  The first is d + z, which would lose
;; digits where z is small beside d.
(define (two-real half square a b c d)
  (define root (flsqrt square))
  (define z (if (fl< half 0.0) (fl- half root) (fl+ half root)))
  (if (fl= z 0.0)
      (list d d)
      (let ([change (fl/ (fl* b c) z)])
        (sort (list (fl+ a change) (fl- d change)) <))))

;; One step on the block: a reflection of three coordinates makes the first column of
;; the shifted square a multiple of the first axis, and others chase the bulge which it
;; leaves down and out of the matrix.
(define (Francis-step! h n first last unusual?)
  (define-values (x y z) (first-column h n first last unusual?))
  (let chase ([k first] [x x] [y y] [z z])
    (define three? (< (+ k 1) last))
    (reflect! h n first last k x y (if three? z 0.0))
    (when three?
      (chase (+ k 1)
             (at h n (+ k 1) k)
             (at h n (+ k 2) k)
             (if (< (+ k 2) last) (at h n (+ k 3) k) 0.0)))))

;; The first column of H² - (σ + σ̄) H + σ σ̄, which ends after three entries.
(define (first-column h n first last unusual?)
  (define k (- last 1))
  (define-values (sum product)
    (if unusual?
        (let ([s (fl+ (flabs (at h n last k)) (flabs (at h n k (- k 1))))])
          (values (fl* 1.5 s) (fl* s s)))
        (values (fl+ (at h n k k) (at h n last last))
                (fl- (fl* (at h n k k) (at h n last last))
                     (fl* (at h n k last) (at h n last k))))))
  (define-values (a b c d)
    (values (at h n first first) (at h n first (+ first 1))
            (at h n (+ first 1) first) (at h n (+ first 1) (+ first 1))))
  (values (fl+ (fl+ (fl* a (fl- a sum)) product) (fl* b c))
          (fl* c (fl- (fl+ a d) sum))
          (fl* c (at h n (+ first 2) (+ first 1)))))

;; The reflection 1 - β v v* that sends (x y z) to the first axis acts on rows and
;; columns k, k + 1 and k + 2.
(define (reflect! h n first last k x y z)
  (define size (flmax (flabs x) (flmax (flabs y) (flabs z))))
  (unless (fl= size 0.0)
    (define-values (p q r) (values (fl/ x size) (fl/ y size) (fl/ z size)))
    (define long (flsqrt (fl+ (fl* p p) (fl+ (fl* q q) (fl* r r)))))
    (define v0 (if (fl< p 0.0) (fl- p long) (fl+ p long)))
    (define-values (v1 v2) (values (fl/ q v0) (fl/ r v0)))
    (define beta (fl/ 2.0 (fl+ 1.0 (fl+ (fl* v1 v1) (fl* v2 v2)))))
    (define count (if (< (+ k 1) last) 3 2))
    (for ([j (in-range (max first (- k 1)) (+ last 1))])
      (reflect-three! h (+ (* k n) j) n count beta v1 v2))
    (for ([i (in-range first (+ 1 (min last (+ k 3))))])
      (reflect-three! h (+ (* i n) k) 1 count beta v1 v2))
    (when (> k first)
      (put! h n (+ k 1) (- k 1) 0.0)
      (when (= count 3) (put! h n (+ k 2) (- k 1) 0.0)))))

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
