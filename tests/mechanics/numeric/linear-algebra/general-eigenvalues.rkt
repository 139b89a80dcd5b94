#lang racket/base
;; Eigenvalues of matrices of flonums: against known ones, and against what they leave
;; alone: the traces of the matrix and of its powers.

(require racket/flonum
         racket/math
         racket/set
         mechanics/numeric/linear-algebra/general-eigenvalues
         mechanics/numeric/linear-algebra/symmetric-eigenvalues
         "../../support/checks.rkt")

(define seed 2107)

(define (random-matrix n [symmetric? #f])
  (define m (build-vector (* n n) (lambda (_) (- (random) 0.5))))
  (for/flvector #:length (* n n) ([k (in-range (* n n))])
    (define-values (i j) (quotient/remainder k n))
    (vector-ref m (if (and symmetric? (< i j)) (+ (* j n) i) k))))

(define (product a b n)
  (for*/flvector #:length (* n n) ([i (in-range n)] [j (in-range n)])
    (for/fold ([sum 0.0]) ([k (in-range n)])
      (fl+ sum (fl* (flvector-ref a (+ (* i n) k)) (flvector-ref b (+ (* k n) j)))))))

(define (trace a n)
  (for/fold ([sum 0.0]) ([i (in-range n)]) (+ sum (flvector-ref a (* i (+ n 1))))))

(define (check-traces found a n)
  (check-equal? (length found) n)
  (for/fold ([power a]) ([k (in-range 1 6)])
    (define sum (apply + (map (lambda (z) (expt z k)) found)))
    (check-= (real-part sum) (trace power n) 1e-10 (format "power ~a, n = ~a, seed ~a" k n seed))
    (check-= (imag-part sum) 0 1e-10)
    (product power a n)))

(test-case "sums of powers are the traces of the powers"
  (random-seed seed)
  (for* ([n '(1 2 3 4 5 8 13 30)] [again 5])
    (define a (random-matrix n))
    (check-traces (real-matrix-eigenvalues a n) a n)))

;; The companion of (x - z₁)(x - z₂)…
(define (companion zeros)
  (define n (length zeros))
  (define coefficients
    (for/fold ([c '(1)]) ([z (in-list zeros)])
      (map - (append c '(0)) (cons 0 (map (lambda (x) (* z x)) c)))))
  (define m (make-flvector (* n n)))
  (for ([c (in-list (cdr coefficients))] [j (in-naturals)])
    (flvector-set! m j (real->double-flonum (- (real-part c)))))
  (for ([i (in-range 1 n)]) (flvector-set! m (+ (* i n) i -1) 1.0))
  m)

(define (check-zeros zeros tolerance)
  (define found (real-matrix-eigenvalues (companion zeros) (length zeros)))
  (for ([z (in-list zeros)])
    (check-true (for/or ([x (in-list found)]) (< (magnitude (- x z)) tolerance))
                (format "~a among ~a" z found))))

(test-case "zeros of polynomials: real, complex, of magnitude one, many times"
  (check-zeros '(1 2 3 4 5 6) 1e-9)
  (check-zeros '(1+2i 1-2i -3 0.5) 1e-12)
  (check-zeros (for/list ([k 7]) (make-polar 1.0 (* 2 pi k 1/7))) 1e-13)
  (check-zeros '(1 1 1) 1e-4)
  (check-zeros '(0 0 2 3) 1e-6))

(test-case "scales of coordinates do not count"
  (define scales '(1 1e-6 1e6 1e3))
  (define m (companion '(1 2 3 4)))
  (define scaled
    (for*/flvector #:length 16 ([i 4] [j 4])
      (* (flvector-ref m (+ (* 4 i) j)) (/ (list-ref scales i) (list-ref scales j)))))
  (check-within (sort (real-matrix-eigenvalues scaled 4) <) '(1.0 2.0 3.0 4.0) 1e-10))

;; λ² − (a + d) λ + (a d − b c) = 0, with the product of both for the smaller.
(define (check-two a b c d)
  (define-values (A B C E) (apply values (map inexact->exact (list a b c d))))
  (define-values (sum product) (values (+ A E) (- (* A E) (* B C))))
  (define root (sqrt (real->double-flonum (+ (* (- A E) (- A E)) (* 4 B C)))))
  (define larger (/ (+ sum (if (< sum 0) (- root) root)) 2.0))
  (define smaller (real->double-flonum (/ product (inexact->exact larger))))
  (define conditioned                     ; how many digits the entries leave of the product
    (real->double-flonum (/ (+ (abs (* A E)) (abs (* B C))) (abs product))))
  (define found (sort (real-matrix-eigenvalues (flvector a b c d) 2) < #:key abs))
  (for ([x (in-list found)] [y (in-list (list smaller larger))])
    (check-= (/ x y) 1 (* 1e-14 conditioned) (format "~a ~a; ~a ~a" a b c d))))

(test-case "two rows: the smaller eigenvalue keeps its digits beside the larger"
  (check-two -1e8 1.0 2.0 -1e-7)          ; -8.0e-8
  (check-two -1e-7 2.0 1.0 -1e8)
  (check-two 1e8 1.0 2.0 1e-7)
  (check-two 1e-7 1.0 2.0 1e8)
  (check-two 1.0 1e-16 1e-16 2e-32)       ; 1.0e-32, by entries that are nothing beside 1
  (random-seed seed)
  (for ([_ 200])
    (define (entry) (* (if (zero? (random 2)) 1.0 -1.0) (expt 10.0 (- (* 16.0 (random)) 8.0))))
    (define-values (a b d) (values (entry) (entry) (entry)))
    (define c (* (/ b (abs b)) (abs (entry))))                          ; b c > 0: both real
    (check-two a b c d)))

;; 1 ± √(b c), with products that are nothing beside 1
(test-case "a small product of the entries off the diagonal keeps its sign"
  (for ([sign '(1.0 -1.0)])
    (define (eigenvalues b c) (real-matrix-eigenvalues (flvector 1.0 b c 1.0) 2))
    (define root (* (expt 2.0 -31) (sqrt sign)))
    (for ([found (list (eigenvalues (* sign (expt 2.0 -10)) (expt 2.0 -52))
                       (eigenvalues (expt 2.0 -52) (* sign (expt 2.0 -10))))])
      (check-equal? (list->set found) (set (- 1.0 root) (+ 1.0 root))))))

(test-case "nothing separates where there is no number"
  (check-false (real-matrix-eigenvalues (make-flvector 9 +nan.0) 3)))

(define (check-symmetric a n)
  (define-values (found vectors) (symmetric-eigenvalues a n))
  (check-equal? (sort (for/list ([x (in-flvector found)]) x) <)
                (for/list ([x (in-flvector found)]) x))
  (define (entry m i k) (flvector-ref m (+ (* i n) k)))
  (define (component i k) (flvector-ref (list-ref vectors i) k))
  (for* ([i n] [j n])
    (check-= (for/sum ([k n]) (* (component i k) (component j k))) (if (= i j) 1 0) 1e-13)
    (check-= (for/sum ([k n]) (* (entry a j k) (component i k)))
             (* (flvector-ref found i) (component i j)) 1e-13)))

(test-case "symmetric matrices: vectors of unit length at right angles, each turned into a multiple"
  (random-seed seed)
  (for ([n '(1 2 3 5 10 25)]) (check-symmetric (random-matrix n #t) n))
  (check-symmetric (flvector 0.0 2.0 2.0 0.0) 2)
  (check-symmetric (make-flvector 9 1.0) 3)
  (check-symmetric (make-flvector 16 0.0) 4))

(test-case "a chain of n springs has 2 - 2 cos(k π/(n + 1))"
  (define n 20)
  (define a (make-flvector (* n n)))
  (for ([i n])
    (flvector-set! a (* i (+ n 1)) 2.0)
    (when (> i 0)
      (flvector-set! a (+ (* i n) i -1) -1.0)
      (flvector-set! a (+ (* (- i 1) n) i) -1.0)))
  (define-values (found vectors) (symmetric-eigenvalues a n))
  (for ([k n])
    (check-= (flvector-ref found k) (- 2 (* 2 (cos (/ (* pi (+ k 1)) (+ n 1))))) 1e-14)))

(test-case "a slow mode beside fast ones keeps its digits"
  ;; d (1 c; c 1) d with d = (1, 1e-8): the small one is 1e-16 (1 - c²) nearly
  (define-values (found vectors)
    (symmetric-eigenvalues (flvector 1.0 0.5e-8 0.5e-8 1e-16) 2))
  (check-= (/ (flvector-ref found 0) 0.75e-16) 1 1e-14))

(test-case "so it does where the entry between them is nothing beside the fast one"
  (for ([d (in-list '(1e-12 1e-17 1e-40 1e-100))])
    (define-values (found vectors)
      (symmetric-eigenvalues (flvector 1.0 (* 0.5 d) (* 0.5 d) (* d d)) 2))
    (check-= (/ (flvector-ref found 0) (* 0.75 d d)) 1 1e-14 (format "d = (1, ~a)" d))))
