#lang racket/base
;; Flonum systems: against exact arithmetic, and where they stop making sense.

(require mechanics/numeric/linear-algebra/flonum-systems
         mechanics/algebra/elimination/elimination
         "../../support/checks.rkt"
         "../../support/close.rkt" "../../support/matrices.rkt" "../../support/random.rkt")

(define (exact A) (for/vector ([row A]) (for/vector ([x row]) (inexact->exact x))))

(define (close-rows? A B tolerance)
  (for/and ([r A] [s B]) (for/and ([x r] [y s]) (close? x y tolerance))))

(test-case "determinants and solutions agree with exact arithmetic on the same numbers"
  (with-seed 441
    (for ([n '(1 2 3 5 10 30)])
      (define A (random-rows n 1 random-flonum))
      (define b (random-rows n 1 random-flonum 2))
      (define d (eliminated-determinant (exact A) 1))
      (check-true (close? (/ (floating-determinant A) (exact->inexact d)) 1.0 1e-9))
      (check-true (close-rows? (floating-solutions A b)
                               (eliminated-solutions (exact A) (exact b) 1)
                               1e-8)))))

(test-case "complex systems"
  (with-seed 442
    (for ([n '(1 2 4 6)])
      (define A (random-rows n 1 random-complex))
      (define x (random-rows n 1 random-complex 1))
      (check-true (close-rows? (floating-solutions A (times A x)) x 1e-9)))))

(test-case "a small pivot is avoided"
  (check-true (close-rows? (floating-solutions #(#(1e-20 1.0) #(1.0 1.0)) #(#(1.0) #(2.0)))
                           #(#(1.0) #(1.0)) 1e-12)))

(test-case "units do not make a matrix singular"
  (check-equal? (floating-solutions #(#(1.0 1e20) #(0.0 1.0)) #(#(1.0) #(2.0))) #(#(-2e20) #(2.0)))
  (check-equal? (floating-solutions #(#(1e-30 0.0) #(0.0 1e30)) #(#(1e-30) #(1e30)))
                #(#(1.0) #(1.0)))
  (with-seed 443
    (for ([_ 10])
      (define A (random-rows 5 1 random-flonum))
      (define (scale) (expt 10.0 (random-integer -12 12)))
      (define left (for/vector ([_ 5]) (scale)))
      (define right (for/vector ([_ 5]) (scale)))
      (define scaled
        (rows 5 (lambda (i j) (* (vector-ref left i) (vector-ref right j)
                                 (vector-ref (vector-ref A i) j)))))
      (check-pred vector? (floating-solutions scaled (identity-rows 5))))))

(test-case "a matrix within rounding of a singular one is singular"
  (check-eq? (floating-solutions #(#(0.1 0.3) #(0.3 0.9)) #(#(1.0) #(2.0))) 'singular)
  (check-eq? (floating-solutions #(#(1.0 2.0) #(2.0 4.0)) #(#(1.0) #(2.0))) 'singular)
  (check-eq? (floating-solutions #(#(0.0 0.0) #(0.0 1.0)) #(#(1.0) #(2.0))) 'singular)
  (define s (sin 3.141592653589793))
  (check-eq? (floating-solutions (vector (vector (* s s) 0.0 0.0)
                                         (vector s 3.0 -3.0) (vector 0.0 -3.0 3.0))
                                 #(#(1.0) #(1.0) #(1.0)))
             'singular))

(test-case "an ill-conditioned matrix still has digits: Hilbert's of 10 rows"
  (define n 10)
  (define H (rows n (lambda (i j) (/ 1.0 (+ i j 1)))))
  (define x (floating-solutions H (times H (rows n (lambda (i j) 1.0) 1))))
  (check-true (close-rows? x (rows n (lambda (i j) 1.0) 1) 1e-2)))

(test-case "what is not a number stays so"
  (check-true (for/or ([row (floating-solutions #(#(+nan.0 1.0) #(1.0 2.0)) #(#(1.0) #(2.0)))])
                (not (= (vector-ref row 0) (vector-ref row 0))))))

(test-case "rank and null space of flonums"
  (with-seed 444
    (for ([r '(1 2 3)] [n '(3 5 7)])
      (define A (times (random-rows n 1 random-flonum r) (random-rows r 1 random-flonum n)))
      (define-values (rank vectors) (floating-kernel A))
      (check-equal? rank r)
      (check-equal? (length vectors) (- n r))
      (for ([v (in-list vectors)])
        (check-true (close-rows? (times A (for/vector ([x v]) (vector x)))
                                 (rows n (lambda (i j) 0.0) 1) 1e-12))
        (check-equal? (for/fold ([m 0.0]) ([x v]) (max m (abs x))) 1.0)))))
