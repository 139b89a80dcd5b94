#lang racket/base
;; Systems of ten and more equations were differentiated through characteristic polynomials,
;; which lose all digits where eigenvalues are of different sizes.

(require racket/flonum
         mechanics mechanics/value/matrix/linear-algebra
         tests/mechanics/support/systems
         "../support/checks.rkt")

(define (list->up xs) (apply up xs))
(define (angles n) (for/list ([k n]) (sin (* 3.1 (+ k 1)))))
(define (rates n) (for/list ([k n]) (cos (* 1.7 (+ k 1)))))

;; The acceleration of the first link of a chain whose first angle is h greater.
(define (first-acceleration n f)
  (define-values (q v) (values (angles n) (rates n)))
  (lambda (h)
    (ref (f (up 0.0 (list->up (cons (+ (car q) h) (cdr q))) (list->up v))) 2 0)))

;; By differences, of which only values are needed: to the eighth order.
(define (difference f h)
  (for/sum ([c '(672/840 -168/840 32/840 -3/840)] [k '(1 2 3 4)])
    (/ (* c (- (f (* k h)) (f (* -1 k h)))) h)))

(define (check-close x expected tolerance)
  (check-= x expected (* tolerance (+ 1 (abs expected)))))

(test-case "derivatives, gradients, jets and compiled derivatives of long chains"
  (for ([n '(9 11)])
    (define f (Lagrangian->state-derivative (L-chain n 9.8)))
    (define s (up 0.0 (list->up (angles n)) (list->up (rates n))))
    (define a (first-acceleration n f))
    (define expected (difference a 0.004))
    (check-close ((D a) 0.0) expected 1e-9)
    (check-close (ref ((D f) s) 1 0 2 0) expected 1e-9)
    (check-close (ref ((gradient (lambda (s) (ref (f s) 2 0))) s) 1 0) expected 1e-9)
    (check-close ((D (D a)) 0.0) (difference (D a) 0.004) 1e-8)
    (check-close (((expt D 3) a) 0.0) (difference (D (D a)) 0.004) 1e-7)
    (define columns
      ((compile-function (D f) s) (apply flvector 0.0 (append (angles n) (rates n)))))
    (check-close (flvector-ref columns (+ (* 1 (+ 1 n n)) 1 n)) expected 1e-9)))

;; Exact: with A x = b, A x' = b' − A' x.
(test-case "of exact numbers they are exact"
  (define n 11)
  (define ((entries f) x) (apply down (for/list ([j n]) (apply up (for/list ([i n]) (f x i j))))))
  (define A (entries (lambda (x i j) (+ (if (= i j) 5 0) (/ (+ 1 (* x i)) (+ 1 i j j))))))
  (define A′ (entries (lambda (x i j) (/ i (+ 1 i j j)))))
  (define (b x) (apply up (for/list ([i n]) (* x x (+ i 1)))))
  (define (b′ x) (apply up (for/list ([i n]) (* 2 x (+ i 1)))))
  (define (solution x) (solve-linear-left (A x) (b x)))
  (define x (solution 1/3))
  (check-equal? ((D solution) 1/3)
                (solve-linear-left (A 1/3) (- (b′ 1/3) (* (A′ 1/3) x)))))

(test-case "determinants: pivots chosen by their values, or no pivots where there are none"
  (define ((mass n) x)
    (apply up (for/list ([i n])
                (apply down (for/list ([j n])
                              (* (- n (max i j)) (cos (* x (- (square i) (square j))))))))))
  (for ([n '(5 10 14)])
    (define d (compose determinant (mass n)))
    (check-close ((D d) 0.3) (difference (lambda (h) (d (+ 0.3 h))) 5e-4) 1e-8))
  ;; Of rank n - 1 and of rank n - 2.
  (define ((diagonal zeros n) x)
    (apply up (for/list ([i n])
                (apply down (for/list ([j n])
                              (cond [(= i j) (if (< i zeros) x (+ 1.0 i))]
                                    [else (* x 0.25 (- i j))]))))))
  (define (product from to) (for/product ([i (in-range from to)]) (+ 1.0 i)))
  (check-close ((D (compose determinant (diagonal 1 5))) 0.0) (product 1 5) 1e-14)
  (check-close ((D (compose determinant (diagonal 2 5))) 0.0) 0.0 1e-14))
