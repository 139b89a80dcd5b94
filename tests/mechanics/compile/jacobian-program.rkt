#lang racket/base
;; Derivatives of programs, as implicit methods take them: those of D, and of differences in
;; numbers of 200 bits.

(require (only-in math/bigfloat bf bf+ bf- bf* bf/ bfsin bfexp bfsqrt bfsqr bflog bfatan 1.bf
                  bf-precision bigfloat->flonum)
         racket/flonum
         mechanics
         (only-in mechanics/compile/Racket-code program->maker)
         (only-in mechanics/compile/compile-function compiled-function-program)
         (only-in mechanics/compile/closures program->closure-maker)
         (only-in mechanics/compile/program program-inputs program-length program-outputs)
         (only-in mechanics/compile/derivative-sweep
                  jacobian-program program-with-gradient tangent-program)
         (only-in mechanics/value/shape scalars structure->flvector flvector->structure)
         "../support/checks.rkt")

(define (program-of f example) (compiled-function-program (compile-function f example)))

(define (run p input [maker program->closure-maker])
  (define output (make-flvector (vector-length (program-outputs p))))
  (((maker p)) input output)
  output)

(define (near? x y tolerance) (<= (abs (- x y)) (* tolerance (+ 1 (abs x) (abs y)))))

;; Column by column
(define (by-D f example v)
  (structure->flvector ((D f) (flvector->structure example v)) (lambda (x) +nan.0)))

;; Central differences of f : vector of bigfloats -> list of bigfloats
(define (by-differences f v)
  (define xs (for/vector ([x (in-flvector v)]) (bf x)))
  (define h (bf "1e-25"))
  (define (moved k step)
    (f (for/vector ([x (in-vector xs)] [j (in-naturals)]) (if (= j k) (bf+ x step) x))))
  (for*/list ([k (in-range (vector-length xs))]
              [pair (in-list (map cons (moved k h) (moved k (bf- h))))])
    (bigfloat->flonum (bf/ (bf- (car pair) (cdr pair)) (bf* (bf 2) h)))))

(define (random-point n) (for/flvector #:length n ([_ (in-range n)]) (+ 0.2 (* 0.6 (random)))))

(define (check-jacobian f n [precise #f])
  (define example (vector->up (make-vector n 0.5)))
  (define J (jacobian-program (program-of f example) n))
  (for ([_ (in-range 3)])
    (define v (random-point n))
    (define found (run J v))
    (define expected (by-D f example v))
    (check-equal? (flvector-length found) (flvector-length expected))
    (check-equal? found (run J v program->maker))
    (for ([x (in-flvector found)] [y (in-flvector expected)])
      (unless (near? x y 1e-11) (check-equal? x y)))
    (when precise
      (for ([x (in-flvector found)] [y (in-list (by-differences precise v))])
        (unless (near? x y 1e-13) (check-equal? x y))))))

(random-seed 1717)

(define operations
  (list sin cos tan asin acos atan sinh cosh tanh asinh atanh exp log sqrt abs
        (lambda (x) (acosh (+ 2 x))) (lambda (x) (expt x 3.7)) (lambda (x) (expt x -2))
        (lambda (x) (expt 3 x)) (lambda (x) (expt x x)) (lambda (x) (/ 1 x))
        (lambda (x) (/ x (+ 1 x))) (lambda (x) (- 2 x)) (lambda (x) 7) -))

(test-case "of every operation"
  (for ([f operations])
    (check-jacobian (lambda (s) (up (* (ref s 1) (f (ref s 0))) (f (* (ref s 0) (ref s 1)))))
                    2))
  (check-jacobian (lambda (s) (up (atan (ref s 0) (ref s 1)) (expt (ref s 0) (ref s 1)))) 2))

(test-case "against differences in 200 bits"
  (parameterize ([bf-precision 200])
    (check-jacobian (lambda (s)
                      (define-values (x y z) (values (ref s 0) (ref s 1) (ref s 2)))
                      (up (/ (sin (* x y)) (+ 1 (exp z)))
                          (sqrt (+ (square x) (cube y)))
                          (* x (log (+ 2 z)) (atan y))))
                    3
                    (lambda (v)
                      (define-values (x y z) (vector->values v))
                      (list (bf/ (bfsin (bf* x y)) (bf+ 1.bf (bfexp z)))
                            (bfsqrt (bf+ (bfsqr x) (bf* y (bfsqr y))))
                            (bf* x (bf* (bflog (bf+ (bf 2) z)) (bfatan y))))))))

(test-case "of a linear system whose matrix varies, and of one of its unknowns alone"
  (define (unknowns s)
    (define m (matrix-by-rows (list (+ 3 (ref s 0)) (ref s 1))
                              (list (sin (ref s 2)) (+ 2 (ref s 1)))))
    (* (/ 1 m) (up (ref s 2) (square (ref s 0)))))
  (check-jacobian unknowns 3)
  (check-jacobian (lambda (s) (up (ref (unknowns s) 1))) 3))

;; More than three unknowns are left to an elimination with numbers.
(define (four-unknowns s)
  (define-values (x y) (values (ref s 0) (ref s 1)))
  (solve-linear-left (matrix-by-rows (list (+ 4 x) y 1 0) (list x (- 5 y) 0 1)
                                     (list (* x y) 1 3 y) (list 0 (cos y) x 6))
                     (up x y 1 (* x y))))

(test-case "of a system solved by elimination"
  (check-jacobian four-unknowns 2))

;; compile-function goes another way where the sweep is wrong; here is the sweep itself.
(define (check-sweep f)
  (define c (program-with-gradient (program-of f (up 0.5 0.5))))
  (for ([_ (in-range 3)])
    (define v (random-point 2))
    (define expected (cons (f (flvector->structure (up 0 0) v))
                           (for/list ([x (in-flvector (by-D f (up 0 0) v))]) x)))
    (for ([x (in-flvector (run c v))] [y (in-list expected)])
      (unless (near? x y 1e-11) (check-equal? x y)))))

(test-case "one sweep backwards: of every operation, and of a system that is not symmetric"
  (for ([f operations]) (check-sweep (lambda (s) (* (ref s 1) (f (ref s 0))))))
  (check-sweep (lambda (s) (/ (- (ref s 0) (* 3 (ref s 1))) (+ (ref s 0) (sqrt (ref s 1))))))
  (check-sweep (lambda (s) (+ (atan (ref s 0) (ref s 1)) (expt (ref s 0) (ref s 1)))))
  (check-sweep (lambda (s) ((principal-value :pi) (* 3 (ref s 0) (ref s 1)))))
  (check-sweep (lambda (s) (dot-product (four-unknowns s) (up 1 (ref s 1) 0 2))))
  (define (first-unknown s)
    (define m (matrix-by-rows (list 4 1 0 (ref s 0)) '(0 5 1 0) '(1 0 3 1) '(0 0 1 6)))
    (ref (solve-linear-left m (up 1 (ref s 1) 0 0)) 0))
  (check-sweep first-unknown))

(test-case "by the first inputs only, the others being parameters"
  (define p (program-of (lambda (s) (up (* (ref s 1) (ref s 0)) (+ (ref s 2) (square (ref s 0)))))
                        (up 1 2 3)))
  (check-equal? (run (jacobian-program p 1) (flvector 5.0 7.0 11.0)) (flvector 7.0 10.0))
  (check-equal? (run (jacobian-program p 2) (flvector 5.0 7.0 11.0)) (flvector 7.0 10.0 5.0 0.0))
  (check-equal? (run (tangent-program p) (flvector 5.0 7.0 11.0))
                (flvector 7.0 5.0 0.0 10.0 0.0 1.0)))

(test-case "what has no derivative, or takes too many operations, has none"
  (define p (program-of (lambda (s) (up (sin (ref s 0)) (* (ref s 0) (exp (ref s 1))))) (up 1 2)))
  (check-false (jacobian-program p 2 #:most 3))
  (check-true (<= (program-length (jacobian-program p 2 #:most 10)) 10)))

;; Each mass has two neighbours, and a row four derivatives.
(test-case "sparse where the function is: a row of springs takes some operations each"
  (define (springs n)
    (lambda (s)
      (define (x k) (if (< -1 k n) (ref s k) 0))
      (vector->up (for/vector ([k n])
                    (- (sin (- (x (+ k 1)) (x k))) (sin (- (x k) (x (- k 1)))))))))
  (define (operations n)
    (define p (program-of (springs n) (vector->up (make-vector n 0.5))))
    (/ (program-length (jacobian-program p n)) (program-length p)))
  (check-jacobian (springs 9) 9)
  (check-true (< (operations 100) 2)))
