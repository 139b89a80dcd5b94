#lang racket/base
;; Taylor coefficients by recurrences, compared with Cauchy's integrals of the same functions
;; over a circle, which know nothing of recurrences.

(require racket/flonum (only-in racket/list last) racket/math
         (prefix-in m: mechanics)
         (only-in mechanics/algebra/expression/numeric-functions erf)
         mechanics/compile/jet/jet-program mechanics/compile/trace
         mechanics/numeric/Taylor/expansion
         "../../support/checks.rkt")

;; ---------------------------------------------------------------------------
;; Cauchy's formula: c_k = 1/M Σ f(r e^(iφ)) e^(−ikφ) / r^k

(define points 128)

(define (coefficients-by-Cauchy f radius count)
  (define values
    (for/vector #:length points ([m (in-range points)])
      (f (* radius (exp (* 2 pi +i (/ m points)))))))
  (for/list ([k (in-range count)])
    (/ (real-part (for/sum ([v (in-vector values)] [m (in-range points)])
                    (* v (exp (* -2 pi +i (/ (* k m) points))))))
       points (expt radius k))))

;; The two arguments, as functions of a complex time.
(define a-coefficients '(0.6 0.3 -0.2 0.1 0.05 -0.02))
(define b-coefficients '(1.3 -0.2 0.1 0.15 -0.1 0.03))
(define ((polynomial cs) t) (for/sum ([c (in-list cs)] [k (in-naturals)]) (* c (expt t k))))
(define a (polynomial a-coefficients))
(define b (polynomial b-coefficients))

(define order 12)

;; The coefficients of (f x y), generic, where x and y are a and b.
(define (coefficients-by-recurrence f)
  (define-values (p shape)
    (trace 'test (lambda (s) (m:up (f (m:ref s 0) (m:ref s 1)))) (m:up 0.6 1.3)))
  (define make (program->expansion-maker p 2 #:follow? #t))
  (define e (make order (flvector 0.0 0.0)))
  (for ([row (in-vector (expansion-states e))] [cs (list a-coefficients b-coefficients)])
    (for ([c (in-list cs)] [k (in-naturals)]) (flvector-set! row k c)))
  (follow! e)
  (for/list ([c (in-flvector (vector-ref (expansion-slopes e) 0))]) c))

(define (check-coefficients name f complex-f)
  (define expected
    (coefficients-by-Cauchy (lambda (t) (complex-f (a t) (b t))) 0.3 (+ order 1)))
  (for ([x (in-list (coefficients-by-recurrence f))] [y (in-list expected)] [k (in-naturals)])
    (check-= x y (* 1e-14 (expt 1/0.3 k) 10) (format "~a, order ~a" name k))))

(define 1/0.3 (/ 1 0.3))
(define (unary f) (lambda (x y) (f x)))

;; In terms of logarithms and exponentials, of complex numbers.
(define (ln1 z) (log (+ 1 z)))
(define (asinh* z) (log (+ z (sqrt (+ (* z z) 1)))))
(define (acosh* z) (log (+ z (* (sqrt (+ z 1)) (sqrt (- z 1))))))
(define (atanh* z) (* 1/2 (- (ln1 z) (ln1 (- z)))))

(define functions
  (list (list 'sin m:sin sin) (list 'cos m:cos cos) (list 'tan m:tan tan)
        (list 'asin m:asin asin) (list 'acos m:acos acos) (list 'atan m:atan atan)
        (list 'exp m:exp exp) (list 'log m:log log) (list 'sqrt m:sqrt sqrt)
        (list 'sinh m:sinh sinh) (list 'cosh m:cosh cosh) (list 'tanh m:tanh tanh)
        (list 'asinh m:asinh asinh*) (list 'atanh m:atanh atanh*) (list 'erf m:erf erf)))

(for ([entry (in-list functions)])
  (test-case (format "coefficients of ~a" (car entry))
    (check-coefficients (car entry) (unary (cadr entry)) (unary (caddr entry)))))

(test-case "coefficients of acosh, beyond 1"
  (check-coefficients 'acosh (lambda (x y) (m:acosh y)) (lambda (x y) (acosh* y))))

(test-case "both of a pair"
  (check-coefficients 'sin*cos (unary (lambda (x) (m:* (m:sin x) (m:cos x))))
                      (unary (lambda (x) (* (sin x) (cos x)))))
  (check-coefficients 'sinh/cosh (unary (lambda (x) (m:/ (m:sinh x) (m:cosh x))))
                      (unary tanh)))

(test-case "products, quotients and sums of several"
  (check-coefficients '* m:* *)
  (check-coefficients '/ m:/ /)
  (check-coefficients 'sums
                      (lambda (x y)
                        (m:+ 2 (m:* x y) (m:* 3 (m:square x)) (m:* -1 (m:square y)) (m:cube x)
                             (m:* 4 x (m:cube y)) (m:sin x) (m:* -1/2 y)))
                      (lambda (x y)
                        (+ 2 (* x y) (* 3 x x) (- (* y y)) (* x x x) (* 4 x y y y) (sin x)
                           (* -1/2 y))))
  (check-coefficients 'shared
                      (lambda (x y)
                        (define q (m:exp y))
                        (define (twice z) (m:sin (m:* z q)))
                        (m:+ (twice x) (twice (m:square x)) (twice (m:cube x)) (twice y)))
                      (lambda (x y)
                        (define q (exp y))
                        (define (twice z) (sin (* z q)))
                        (+ (twice x) (twice (* x x)) (twice (* x x x)) (twice y)))))

(test-case "powers"
  (for ([n '(-3/2 3/2 -1/2 5/2 -1 -2 -3 2 3 0.3 -1.7)])
    (check-coefficients n (unary (lambda (x) (m:expt x n))) (unary (lambda (x) (expt x n)))))
  (check-coefficients 'gathered
                      (lambda (x y) (m:/ (m:* 3 x) (m:* y (m:sqrt y))))
                      (lambda (x y) (/ (* 3 x) (* y (sqrt y)))))
  (check-coefficients "of a negative base" (unary (lambda (x) (m:expt (m:- x 1) -3)))
                      (unary (lambda (x) (expt (- x 1) -3))))
  (check-coefficients "to a variable" m:expt expt)
  (check-coefficients "of a number" (unary (lambda (x) (m:expt 2.5 x)))
                      (unary (lambda (x) (expt 2.5 x)))))

(test-case "the angle of a point, in all quadrants"
  (for* ([s '(1 -1)] [c '(1 -1)])
    ;; the derivative, of which there is a formula, and the first coefficient
    (define cs
      (coefficients-by-recurrence (lambda (x y) (m:atan (m:* s x) (m:* c y)))))
    (check-= (car cs) (atan (* s 0.6) (* c 1.3)) 1e-15)
    (define expected
      (coefficients-by-Cauchy (lambda (t) (atan (/ (* s (a t)) (* c (b t))))) 0.3 (+ order 1)))
    (for ([x (in-list (cdr cs))] [y (in-list (cdr expected))] [k (in-naturals 1)])
      (check-= x y (* 1e-13 (expt 1/0.3 k))))))

(test-case "linear systems, of entries that vary and of numbers"
  (define ((solved k) x y)
    (m:ref (m:solve-linear-left (m:matrix-by-rows (list x y 1.0) (list 0.5 (m:sin x) 2.0)
                                                  (list y 1.0 (m:* x y)))
                                (m:up->column-matrix (m:up y 1.0 x)))
           k 0))
  (define (determinant r)
    (define (e i j) (vector-ref (vector-ref r i) j))
    (- (+ (* (e 0 0) (e 1 1) (e 2 2)) (* (e 0 1) (e 1 2) (e 2 0)) (* (e 0 2) (e 1 0) (e 2 1)))
       (* (e 0 2) (e 1 1) (e 2 0)) (* (e 0 0) (e 1 2) (e 2 1)) (* (e 0 1) (e 1 0) (e 2 2))))
  (define ((by-Cramer k) x y)
    (define A (vector (vector x y 1.0) (vector 0.5 (sin x) 2.0) (vector y 1.0 (* x y))))
    (define right (vector y 1.0 x))
    (define with-right
      (for/vector ([row A] [v right])
        (for/vector ([z row] [j (in-naturals)]) (if (= j k) v z))))
    (/ (determinant with-right) (determinant A)))
  (for ([k 3]) (check-coefficients (list 'system k) (solved k) (by-Cramer k))))

;; More than three unknowns are left to an elimination with numbers, which is one recurrence.
(define (eliminated rows)       ; rows with their right sides -> the unknowns
  (if (null? rows)
      '()
      (let* ([pivot (car rows)]
             [others (for/list ([row (cdr rows)])
                       (for/list ([x (cdr row)] [p (cdr pivot)])
                         (- x (* (/ (car row) (car pivot)) p))))]
             [known (eliminated others)])
        (define sum (for/sum ([p (cdr pivot)] [x known]) (* p x)))
        (cons (/ (- (last pivot) sum) (car pivot)) known))))

(test-case "linear systems of four unknowns"
  (define ((solved k) x y)
    (m:ref (m:solve-linear-left
            (m:matrix-by-rows (list (m:+ 4 x) y 1 0) (list x (m:- 5 y) 0 1)
                              (list (m:* x y) 1 3 y) (list 0 (m:cos y) x 6))
            (m:up x y 1 (m:* x y)))
           k))
  (define ((by-elimination k) x y)
    (list-ref (eliminated (list (list (+ 4 x) y 1 0 x) (list x (- 5 y) 0 1 y)
                                (list (* x y) 1 3 y 1) (list 0 (cos y) x 6 (* x y))))
              k))
  (for ([k 4]) (check-coefficients (list 'unknown k) (solved k) (by-elimination k))))

;; ---------------------------------------------------------------------------
;; Functions of the time, which is a row that ends: x' = f(t), so x_{k+1} = f_k / (k + 1)

(define (check-of-time name f complex-f)
  (define-values (p shape)
    (trace 'test (lambda (s) (m:up 1 (f (m:ref s 0)))) (m:up 0.4 0.0)))
  (define e ((program->expansion-maker p 2) order (flvector 0.4 0.0)))
  (expand! e (flvector 0.4 0.0) 0.5)
  (define expected
    (coefficients-by-Cauchy (lambda (s) (* 0.5 (complex-f (+ 0.4 (* 0.5 s))))) 0.4 order))
  (for ([y (in-list expected)] [k (in-naturals)])
    (check-= (flvector-ref (coefficient-row e 1) (+ k 1)) (/ y (+ k 1))
             (* 1e-14 (expt 2.5 k)) (format "~a, order ~a" name k))))

(test-case "functions of the time"
  (check-of-time 'cos (lambda (t) (m:cos (m:+ 1 (m:* 3 t)))) (lambda (t) (cos (+ 1 (* 3 t)))))
  (check-of-time 'polynomial
                 (lambda (t) (m:+ (m:cube t) (m:* -2 (m:square t)) t 5))
                 (lambda (t) (+ (* t t t) (* -2 t t) t 5)))
  (check-of-time 'long (lambda (t) (m:expt t 9)) (lambda (t) (expt t 9)))
  (check-of-time 'mixed
                 (lambda (t) (m:* (m:square t) (m:exp (m:* -1 t)) (m:sin (m:square t))))
                 (lambda (t) (* t t (exp (- t)) (sin (* t t)))))
  (check-of-time 'quotient
                 (lambda (t) (m:/ (m:+ 1 t) (m:+ 2 (m:square t))))
                 (lambda (t) (/ (+ 1 t) (+ 2 (* t t)))))
  (check-of-time 'logarithm (lambda (t) (m:log (m:+ 1 t))) (lambda (t) (log (+ 1 t))))
  (check-of-time 'power (lambda (t) (m:expt (m:+ 1 t) 2.5)) (lambda (t) (expt (+ 1 t) 2.5))))

;; ---------------------------------------------------------------------------

(test-case "a product with the time, which has an end, is no convolution"
  (define (convolutions . rates)
    (define-values (p shape)
      (trace 'test (lambda (s) (apply m:up (for/list ([f rates]) (f (m:ref s 0) (m:ref s 1)))))
             (m:up 0.6 1.3)))
    (work-convolutions
     (expander-work (maker->expander (program->expansion-maker p 2) (flvector 0.0 0.0)))))
  (define (product t x) (m:* t x))
  (check-equal? (convolutions (lambda (t x) 1) product) 0)
  (check-equal? (convolutions product product) 1))

(test-case "what has no recurrence is named"
  (define (reason f)
    (define-values (p shape) (trace 'test (lambda (s) (m:up (f (m:ref s 0)))) (m:up 0.6)))
    (program->expansion-maker p 1))
  (check-equal? (reason m:abs) "the operation `abs` has no Taylor recurrence")
  ;; of a constant any operation will do
  (define-values (p shape)
    (trace 'test (lambda (s) (m:up (m:* (m:ref s 0) (m:abs (m:ref s 1))))) (m:up 0.6 -2.0)))
  (define e ((program->expansion-maker p 1) 4 (flvector 0.6 -2.0)))
  (expand! e (flvector 0.6) 1.0)
  (check-= (flvector-ref (coefficient-row e 0) 2) (* 0.6 2) 1e-15))
