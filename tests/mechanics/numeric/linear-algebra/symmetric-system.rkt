#lang racket/base
;; Symmetric systems, definite and not.

(require racket/fixnum
         racket/flonum
         (only-in mechanics/numeric/flvector flvector-map)
         mechanics/numeric/linear-algebra/factored-system
         mechanics/numeric/linear-algebra/small-symmetric-system
         mechanics/numeric/linear-algebra/symmetric-system
         "../../support/checks.rkt")

(random-seed 21)
(define (random-vector n) (for/flvector #:length n ([_ (in-range n)]) (- (* 2.0 (random)) 1.0)))

;; BᵀB of the rank, and what is added to the diagonal
(define (symmetric n shift [rank n])
  (define b (random-vector (* n n)))
  (for*/flvector #:length (* n n) ([i (in-range n)] [j (in-range n)])
    (for/fold ([sum (if (= i j) (shift i) 0.0)]) ([k (in-range rank)])
      (+ sum (* (flvector-ref b (+ (* k n) i)) (flvector-ref b (+ (* k n) j)))))))

(define (solution solve! a n b)
  (define x (flvector-copy b))
  (solve! (flvector-copy a) n (make-fxvector n) x)
  x)

(define (check-as-elimination n shift)
  (define a (symmetric n shift))
  (define b (random-vector n))
  (for ([x (in-flvector (solution solve-symmetric! a n b))]
        [y (in-flvector (solution solve-dense! a n b))])
    (check-= x y (* 1e-9 (+ 1 (abs y))))))

(test-case "definite ones of all sizes"
  (for* ([n (in-range 1 20)] [shift '(1.0 1.0 30.0)])
    (check-as-elimination n (lambda (i) shift))))

(test-case "nearly singular ones are left to elimination, in any unit"
  (for* ([n '(9 12 15)] [unit '(1.0 1e-20)] [_ (in-range 4)])
    (define a (flvector-map (lambda (x) (* unit x)) (symmetric n (lambda (i) 0.0) (- n 1))))
    (define b (random-vector n))
    (check-equal? (solution solve-symmetric! a n b) (solution solve-dense! a n b))))

(test-case "indefinite ones, found late or at once, are left to elimination"
  (for ([n '(1 2 5 9 14)])
    (check-as-elimination n (lambda (i) (if (= i (- n 1)) -100.0 1.0)))
    (check-as-elimination n (lambda (i) (if (= i 0) -100.0 1.0)))
    (check-as-elimination n (lambda (i) -30.0))))

(test-case "a singular matrix, and what is not a number, give no numbers"
  (define n 3)
  (for ([a (list (flvector 1.0 1.0 0.0  1.0 1.0 0.0  0.0 0.0 1.0)
                 (flvector 1.0 0.0 +nan.0  0.0 1.0 0.0  +nan.0 0.0 1.0)
                 (make-flvector 9 0.0))])
    (for ([x (in-flvector (solution solve-symmetric! a n (flvector 1.0 2.0 3.0)))])
      (check-false (rational? x)))))

(test-case "zeros on the diagonal"
  (check-equal? (solution solve-symmetric! (flvector 0.0 2.0 2.0 0.0) 2 (flvector 2.0 4.0))
                (flvector 2.0 1.0)))

(test-case "small ones are read in the upper triangle alone, and left alone if not definite"
  (for ([n (in-range 1 (+ most-unknowns 1))])
    (define a (symmetric n (lambda (i) 1.0)))
    (define b (random-vector n))
    (define upper (flvector-copy a))
    (for* ([i (in-range n)] [j (in-range i)]) (flvector-set! upper (+ (* i n) j) +nan.0))
    (define x (flvector-copy b))
    (check-true (solve-small! upper n x))
    (for ([x (in-flvector x)] [y (in-flvector (solution solve-dense! a n b))])
      (check-= x y 1e-9))
    (define indefinite (symmetric n (lambda (i) (if (= i (- n 1)) -100.0 1.0))))
    (define before (flvector-copy indefinite))
    (define unsolved (flvector-copy b))
    (check-false (solve-small! indefinite n unsolved))
    (check-equal? (list indefinite unsolved) (list before b))))
