#lang racket/base
;; Eigenvectors of decimals, repeated eigenvalues among them, and singular values of singular
;; matrices.

(require mechanics
         "../../support/checks.rkt" "../../support/close.rkt" "../../support/same.rkt")

;; sizes : how many vectors are expected, for each eigenvalue
(define (check-eigenvectors m sizes) (void (checked-eigenvectors m sizes)))

;; the same, and they are given
(define (checked-eigenvectors m sizes)
  (define found (eigenvectors m))
  (check-equal? (map (lambda (e) (length (cdr e))) found) sizes)
  (for* ([e (in-list found)] [v (in-list (cdr e))])
    (check-true (< (size-of (- (* m v) (* (car e) v))) 1e-9) (format "~a" e))
    (check-= (size-of v) 1 1e-12))
  ;; those of one value are independent: their Gram matrix is the unit matrix
  (for* ([e found] [(v i) (in-indexed (cdr e))] [(w j) (in-indexed (cdr e))] #:when (< i j))
    (check-true (< (magnitude (inner v w)) 1e-9)))
  found)

(define (in-indexed xs) (in-parallel xs (in-naturals)))
(define (inner v w)
  (for/sum ([a (structure->vector v)] [b (structure->vector w)]) (* (conjugate a) b)))
(define (size-of v) (sqrt (magnitude (inner v v))))

(test-case "a repeated eigenvalue with two vectors, one without symmetry"
  (define found
    (checked-eigenvectors (matrix-by-rows '(2. 0. 1.) '(0. 2. 1.) '(0. 0. 3.)) '(1 2)))
  (check-= (car (cadr found)) 2 1e-14)
  (check-eigenvectors (matrix-by-rows '(5.0 -3.0 3.0) '(3.0 -1.0 3.0) '(0.0 0.0 2.0)) '(2)))

(test-case "a multiple of the unit matrix, but for symmetry"
  (check-eigenvectors (matrix-by-rows '(2. 0. 0. 1.) '(0. 2. 0. 1.) '(0. 0. 2. 1.) '(0. 0. 0. 1.))
                      '(1 3)))

(test-case "with fewer vectors than its multiplicity says"
  (check-eigenvectors (matrix-by-rows '(2. 1.) '(0. 2.)) '(1))
  (check-eigenvectors (matrix-by-rows '(2. 1. 0.) '(0. 2. 1.) '(0. 0. 2.)) '(1))
  (check-eigenvectors (matrix-by-rows '(2. 1. 0.) '(0. 2. 0.) '(0. 0. 2.)) '(2)))

;; B D B⁻¹, which hides what D shows
(define (hidden D)
  (define n (m:num-rows D))
  (define B (m:generate n n (lambda (i j) (+ (if (= i j) 3. 0.) (sin (+ (* 7 i) (* 3 j) 1))))))
  (* B D (invert B)))

(test-case "hidden by a change of basis"
  (define (diagonal . xs)
    (m:generate (length xs) (length xs) (lambda (i j) (if (= i j) (list-ref xs i) 0.))))
  (define (value-of e) (car e))
  (define two (checked-eigenvectors (hidden (diagonal 1. 1. 2. 4.)) '(2 1 1)))
  (check-close (map value-of two) '(1 2 4) 1e-12)
  (check-eigenvectors (hidden (diagonal 1. 1. 1. 4.)) '(3 1))
  (define jordan (matrix-by-rows '(1. 1. 0. 0.) '(0. 1. 0. 0.) '(0. 0. 1. 0.) '(0. 0. 0. 5.)))
  (check-close (map value-of (checked-eigenvectors (hidden jordan) '(2 1))) '(1 5) 1e-12)
  (define long (matrix-by-rows '(1. 1. 0. 0.) '(0. 1. 1. 0.) '(0. 0. 1. 0.) '(0. 0. 0. 5.)))
  (check-close (map value-of (checked-eigenvectors (hidden long) '(1 1))) '(1 5) 1e-12))

(test-case "values that are near and not the same keep a vector each"
  (define near (matrix-by-rows '(1. 1.) '(0. 1.0001)))
  (check-eigenvectors near '(1 1))
  (check-eigenvectors (matrix-by-rows '(1. 0. 1.) '(0. 1. 1.) '(0. 0. 1.00001)) '(1 2)))

(test-case "complex ones, twice"
  (define turn (matrix-by-rows '(0. 1. 0. 0.) '(-1. 0. 0. 0.) '(0. 0. 0. 1.) '(0. 0. -1. 0.)))
  (define found (checked-eigenvectors (hidden turn) '(2 2)))
  (check-close (map (lambda (e) (imag-part (car e))) found) '(-1 1) 1e-12)
  (check-eigenvectors turn '(2 2))
  (check-eigenvectors (hidden (matrix-by-rows '(0. 1. 1. 0.) '(-1. 0. 0. 1.)
                                              '(0. 0. 0. 1.) '(0. 0. -1. 0.)))
                      '(1 1)))

;; ---------------------------------------------------------------------------

(define (check-svd m)
  (define-values (U found V) (apply values (svd m)))
  (define n (length found))
  (define S (m:generate n n (lambda (i j) (if (= i j) (list-ref found i) 0))))
  (define (unit? M)
    (for*/and ([i n] [j n]) (< (abs (- (matrix-ref M i j) (if (= i j) 1 0))) 1e-12)))
  (check-true (unit? (* (transpose U) U)) (format "~a" U))
  (check-true (unit? (* (transpose V) V)) (format "~a" V))
  (define back (- (* U S (transpose V)) m))
  (for* ([i (m:num-rows back)] [j (m:num-cols back)])
    (check-= (matrix-ref back i j) 0 1e-12)))

(test-case "of a singular matrix, too, the columns have unit length and are orthogonal"
  (for-each check-svd
            (list (matrix-by-rows '(1 2) '(2 4))
                  (matrix-by-rows '(0 0) '(0 0))
                  (matrix-by-rows '(1 2 3) '(4 5 6) '(7 8 9))
                  (matrix-by-rows '(0 1) '(0 0) '(0 2))
                  (matrix-by-rows '(0 0 0) '(0 1 0))
                  (matrix-by-rows '(1 1 1 1) '(2 2 2 2) '(3 3 3 3)))))

(test-case "eigenvalues and vectors of exact numbers are exact where they are real"
  (define golden (/ (+ 1 (sqrt 5)) 2))
  (check-equal? (eigenvalues (matrix-by-rows '(1 1) '(1 0))) (list golden (- 1 golden)))
  (for ([A (list (matrix-by-rows '(1 1) '(1 0))
                 (matrix-by-rows '(0 1 0 0) '(2 0 0 0) '(0 0 0 1) '(0 0 3 0))
                 (matrix-by-rows (list 2 (sqrt 2)) (list (sqrt 2) 3)))])
    (define found (eigenvectors A))
    (check-equal? (map car found) (eigenvalues A))
    (for* ([pair found] [v (cdr pair)])
      (check-true (proved? (verify-equal (* A v) (* (car pair) v))))))
  (define i√6 (make-rectangular 0 (sqrt 6.0)))
  (check-true (same? (apply up (eigenvalues (matrix-by-rows '(1 2) '(-3 1))))
                     (up (+ 1 i√6) (- 1 i√6)) 1e-15))
  ;; a prime of 31 digits
  (define long (matrix-by-rows (list 0 1) (list (+ (expt 10 30) 57) 0)))
  (check-true (same? (apply up (eigenvalues long)) (up 1e15 -1e15) 1e-15)))

(test-case "what has no formula is told by the name that was called"
  (check-exn (pregexp (string-append "^eigenvectors: the zeros of the matrix leave a block"
                                     ".*[(]eigenvectors [(]exact->"))
             (lambda () (eigenvectors (matrix-by-rows '(1 2 3) '(4 5 6) '(7 8 9))))))
