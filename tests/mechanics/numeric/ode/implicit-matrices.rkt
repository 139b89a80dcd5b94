#lang racket/base
;; Systems c − J of implicit methods, whatever is zero in J.

(require racket/flonum
         mechanics/numeric/ode/implicit-matrices
         "../../support/checks.rkt")

(random-seed 8)

(define (random-number) (- (* 2.0 (random)) 1.0))
(define (random-vector n) (for/flvector #:length n ([_ (in-range n)]) (random-number)))

;; (entry i j) -> a matrix, its columns one after the other
(define (columns n entry)
  (for*/flvector #:length (* n n) ([j (in-range n)] [i (in-range n)]) (entry i j)))

;; (c − J) x, for complex c and x
(define (image J n c x)
  (for/list ([i (in-range n)])
    (- (* c (list-ref x i))
       (for/sum ([j (in-range n)] [y (in-list x)]) (* y (flvector-ref J (+ i (* j n))))))))

(define (check-solutions n J [c 3.7] [a 2.6] [b 3.1])
  (define m (make-matrices n))
  (for ([x (in-flvector J)] [k (in-naturals)]) (flvector-set! (matrices-J m) k x))
  (check-true (factor-matrices! m c a b))
  (define-values (u v w) (values (random-vector n) (random-vector n) (random-vector n)))
  (define-values (x y z) (values (flvector-copy u) (flvector-copy v) (flvector-copy w)))
  (solve-real! m c x)
  (solve-complex! m a b y z)
  (define complex-c (make-rectangular a b))
  (define real-image (image J n c (for/list ([t (in-flvector x)]) t)))
  (define complex-image
    (image J n complex-c (for/list ([s (in-flvector y)] [t (in-flvector z)])
                           (make-rectangular s t))))
  (define rounding (* 1e-11 (+ 1.0 (for*/fold ([most 0.0]) ([v (list x y z)] [t (in-flvector v)])
                                     (max most (abs t))))))
  (for ([t (in-list real-image)] [expected (in-flvector u)]) (check-= t expected rounding))
  (for ([t (in-list complex-image)] [re (in-flvector v)] [im (in-flvector w)])
    (check-= (real-part t) re rounding)
    (check-= (imag-part t) im rounding)))

(test-case "a full matrix, an empty one, one that is a clock"
  (for ([n (in-list '(1 2 5 8))])
    (check-solutions n (columns n (lambda (i j) (random-number))))
    (check-solutions n (make-flvector (* n n))))
  (check-solutions 4 (columns 4 (lambda (i j) (if (= i 0) 0.0 (random-number))))))

;; t, q, v : t' = 1, q' = v
(define (of-motion n)
  (columns (+ n n 1)
           (lambda (i j)
             (cond [(= i 0) 0.0]
                   [(<= i n) (if (= j (+ i n)) 1.0 0.0)]
                   [else (random-number)]))))

(test-case "those of motions, for short steps and for long ones"
  (for* ([n (in-list '(1 2 6))] [c (in-list '(1e4 1.0 1e-2 1e-5 1e-9))])
    (check-solutions (+ n n 1) (of-motion n) c (* 0.7 c) (* 0.8 c))))

(test-case "rows of one entry that refer to each other"
  (define (shift n step) (columns n (lambda (i j) (if (= j (modulo (+ i step) n)) 0.9 0.0))))
  (for* ([n (in-list '(2 3 7))] [step (in-list '(0 1 2 -1))]) (check-solutions n (shift n step)))
  (check-solutions 4 (columns 4 (lambda (i j) (if (= j 3) (+ i 1.0) 0.0)))))

(test-case "sparse ones, at random"
  (for ([_ (in-range 200)])
    (define n (+ 2 (random 6)))
    (check-solutions n (columns n (lambda (i j) (if (< (random) 0.7) 0.0 (random-number)))))))

(test-case "one without an inverse"
  (define m (make-matrices 2))
  (for ([x '(2.0 0.0 0.0 1.0)] [k (in-naturals)]) (flvector-set! (matrices-J m) k x))
  (check-false (factor-matrices! m 2.0 1.0 1.0)))
