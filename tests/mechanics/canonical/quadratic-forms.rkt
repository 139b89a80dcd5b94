#lang racket/base
;; Quadratic Hamiltonians made of known modes by a random symplectic matrix: the modes are found
;; again, and the matrix found is symplectic and makes the form theirs.

(require (only-in racket/list remove-duplicates)
         mechanics
         "../support/checks.rkt" "../support/close.rkt" "../support/messages.rkt")

(random-seed 41)

(define (generate n f) (m:generate n n f))

;; Products of shears q + S p and p + S q
(define (random-symplectic n)
  (define (shear upper?)
    (define S (build-vector n (lambda (i) (build-vector n (lambda (j) (- (* 2 (random)) 1))))))
    (generate (* 2 n)
              (lambda (i j)
                (define-values (k l) (values (modulo i n) (modulo j n)))
                (cond [(= i j) 1.0]
                      [(if upper? (< i n (+ j 1)) (< j n (+ i 1)))
                       (vector-ref (vector-ref S (min k l)) (max k l))]
                      [else 0.0]))))
  (* (shear #t) (shear #f) (shear #t)))

;; blocks : as quadratic-normal-form-blocks gives them, and (free), p²/2, and (Krein ω), two
;; oscillators ω and −ω that are not semisimple
(define (form-of blocks)
  (define n (for/sum ([b blocks]) (if (memq (car b) '(complex Krein)) 2 1)))
  (define entries (make-hash))
  (define (put! i j x) (hash-set! entries (cons i j) x) (hash-set! entries (cons j i) x))
  (for/fold ([j 0]) ([b blocks])
    (define-values (p k) (values (+ n j) (+ n j 1)))
    (define (first-of b) (cadr b))
    (case (car b)
      [(elliptic) (put! j j (first-of b)) (put! p p (first-of b))]
      [(hyperbolic) (put! j p (first-of b))]
      [(free) (put! p p 1.0)]
      [(complex) (put! j p (cadr b)) (put! (+ j 1) k (cadr b))
                 (put! j k (caddr b)) (put! (+ j 1) p (- (caddr b)))]
      [(Krein) (put! j k (- (first-of b))) (put! (+ j 1) p (first-of b))
               (put! j j 1.0) (put! (+ j 1) (+ j 1) 1.0)])
    (+ j (if (memq (car b) '(complex Krein)) 2 1)))
  (generate (* 2 n) (lambda (i j) (hash-ref entries (cons i j) 0.0))))

(define (mixed blocks)
  (define A (form-of blocks))
  (define M (random-symplectic (quotient (m:num-rows A) 2)))
  (define form (* (transpose M) A M))
  (* 1/2 (+ form (transpose form))))

(define (entries m) (for*/list ([i (m:num-rows m)] [j (m:num-cols m)]) (matrix-ref m i j)))
(define (zeros m) (map (lambda (x) 0) (entries m)))

(define (sorted blocks) (sort (map (lambda (b) (map number-key b)) blocks) string<?
                              #:key (lambda (b) (format "~s" b))))
(define (number-key x) (if (number? x) (/ (round (* 1e6 x)) 1e6) x))

(define (check-found . blocks)
  (for ([_ 4])
    (define A (mixed blocks))
    (define f (symplectic-normal-form #:matrix A))
    (check-equal? (quadratic-normal-form-status f) 'found)
    (check-equal? (sorted (quadratic-normal-form-blocks f)) (sorted blocks))
    (define M (quadratic-normal-form-matrix f))
    (define rest (- (* (transpose M) A M) (form-of (quadratic-normal-form-blocks f))))
    (define brackets (symplectic-matrix? M))
    (check-close (entries rest) (zeros rest) 1e-10)
    (check-close (entries brackets) (zeros brackets) 1e-10)))

(test-case "oscillators, of both signs, of equal and of near frequencies"
  (check-found '(elliptic 1.0) '(elliptic -2.0))
  (check-found '(elliptic 1.0) '(elliptic 1.0))
  (check-found '(elliptic 1.0) '(elliptic -1.0))
  (check-found '(elliptic 1.0) '(elliptic -1.0) '(elliptic 1.0))
  (check-found '(elliptic 1.0) '(elliptic 1.00001))
  (check-found '(elliptic 1.0) '(elliptic -1.001))
  (check-found '(elliptic 0.001) '(elliptic -0.002) '(elliptic 1.0)))

(test-case "one coordinate alone; where nothing is to be done the matrix is that of unity"
  (for ([b '((elliptic 1.5) (elliptic -0.4) (hyperbolic 0.7))]) (check-found b))
  (for ([w '(3 -3 3.0)])
    (define f (symplectic-normal-form #:matrix (matrix-by-rows (list w 0) (list 0 w))))
    (check-equal? (quadratic-normal-form-frequencies f) (list w))
    (check-close (entries (quadratic-normal-form-matrix f)) '(1 0 0 1) 1e-15)))

(test-case "saddles and complex exponents, alone and repeated"
  (check-found '(hyperbolic 1.0) '(elliptic 1.0))
  (check-found '(hyperbolic 1.0) '(hyperbolic 1.0))
  (check-found '(hyperbolic 1.0) '(hyperbolic 1.001))
  (check-found '(complex 0.3 0.7))
  (check-found '(complex 0.3 0.7) '(complex 0.3 0.7))
  (check-found '(elliptic -1.5) '(complex 0.3 0.7) '(hyperbolic 2.0)))

(define (statuses . blocks)
  (remove-duplicates
   (for/list ([_ 4])
     (quadratic-normal-form-status (symplectic-normal-form #:matrix (mixed blocks))))))

(test-case "what is not semisimple, and what is near"
  (check-equal? (statuses '(Krein 1.0)) '(not-semisimple))
  (check-equal? (statuses '(free) '(elliptic 1.0)) '(not-semisimple))
  (check-equal? (statuses '(elliptic 1.0) '(elliptic -1.0000001)) '(undecided))
  (check-equal? (statuses '(free)) '(not-semisimple))
  (define resting (symplectic-normal-form #:matrix (matrix-by-rows '(0.0 0.0) '(0.0 1.0))))
  (check-equal? (quadratic-normal-form-status resting) 'not-semisimple)
  (define f (symplectic-normal-form #:matrix (mixed '((elliptic 1.0) (elliptic -1.0000001)))))
  (check-close (quadratic-normal-form-frequencies f) '(1 1) 1e-3))

;; In a magnetic field B, H = ((p_x + B y/2)² + (p_y − B x/2)²)/2: one frequency is B, the other 0.
(test-case "a direction without energy"
  (define f
    (symplectic-normal-form
     (lambda (s)
       (define-values (x y) (values (ref s 1 0) (ref s 1 1)))
       (* 1/2 (+ (square (+ (ref s 2 0) (* 1/2 y))) (square (- (ref s 2 1) (* 1/2 x))))))
     (up 't (up 'x 'y) (down 'p_x 'p_y))))
  (check-equal? (car (quadratic-normal-form-blocks f)) '(zero))
  (check-close (cdr (quadratic-normal-form-frequencies f)) '(1) 1e-14))

(test-case "units do not count"
  (define f (symplectic-normal-form #:matrix (matrix-by-rows '(1e-20 0) '(0 1e30))))
  (check-close (quadratic-normal-form-frequencies f) '(1e5) 1e-6)
  (check-equal? (format "~a" f)
                "symplectic normal form\n  coordinate 0: elliptic, 100000.0 (q² + p²)/2"))

(test-case "exact saddles"
  (define f (symplectic-normal-form #:matrix (matrix-by-rows '(-1 0) '(0 1))))
  (check-pred quadratic-normal-form? f)
  (check-equal? (quadratic-normal-form-blocks f) '((hyperbolic 1)))
  (check-equal? (quadratic-normal-form-distance f) #f)
  (check-equal? (quadratic-normal-form-matrix f) (matrix-by-rows '(1 -1/2) '(1 1/2)))
  ;; (q² − p²)/2 is Q P for q = Q + P/2, p = −Q + P/2: motion grows along positive q
  (define turned (symplectic-normal-form #:matrix (matrix-by-rows '(1 0) '(0 -1))))
  (check-equal? (quadratic-normal-form-matrix turned) (matrix-by-rows '(1 1/2) '(-1 1/2))))

(define (spring s) (+ (* 1/2 (square (ref s 2))) (* 1/2 'k (square (ref s 1)))))

(says
 [(symplectic-normal-form spring (up 't 'q 'p) #:at (up 0 0.0 0.0))
  "symplectic-normal-form: the coefficients of the series of spring are to be numbers; there is k\n"
  "  give the parameters as numbers"]
 [(symplectic-normal-form)
  "symplectic-normal-form: expected a Hamiltonian and a state of symbols, or the matrix of its "
  "second derivatives alone\n"
  "  (symplectic-normal-form H state #:at equilibrium)\n"
  "  (symplectic-normal-form #:matrix m)"]
 [(symplectic-normal-form #:matrix (matrix-by-rows '(1 2) '(3 4)))
  "symplectic-normal-form: expected a symmetric matrix of numbers, with a row for each coordinate "
  "and each momentum\n"
  "  given: (matrix-by-rows (list 1 2) (list 3 4)), a 2 by 2 matrix"]
 [(symplectic-normal-form #:matrix (matrix-by-rows '(1 2) '(2 4)) #:tolerance 1)
  "symplectic-normal-form: expected a tolerance from 1e-16 to 1e-6, relative to the quadratic "
  "terms\n  given: the number 1"]
 [(quadratic-normal-form-matrix 3)
  "quadratic-normal-form-matrix: expected what symplectic-normal-form gives\n"
  "  given: the number 3"])
