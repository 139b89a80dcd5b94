#lang racket/base
;; Minors and characteristic polynomials: the algorithms that do not divide.

(require mechanics/algebra/elimination/minors
         mechanics/algebra/elimination/characteristic
         "../../support/checks.rkt" "../../support/matrices.rkt" "../../support/random.rkt")

(define (determinant-by-minors A)
  (define n (vector-length A))
  ((make-minors number-ring A) (all-lines n) (all-lines n)))

(define (determinant-by-characteristic A) (characteristic-determinant number-ring A))

(test-case "determinants are what the definition says, by either algorithm"
  (with-seed 421
    (for* ([n (in-range 1 7)] [density '(1 0.5)] [_ 4])
      (define A (random-rows n density))
      (check-equal? (determinant-by-minors A) (Leibniz A))
      (check-equal? (determinant-by-characteristic A) (Leibniz A)))))

(test-case "any rows and columns have their minor"
  (define A #(#(1 2 3) #(4 5 6) #(7 8 10)))
  (define minor (make-minors number-ring A))
  (check-equal? (minor #b000 #b000) 1)
  (check-equal? (minor #b010 #b100) 6)
  (check-equal? (minor #b101 #b011) (- (* 1 8) (* 2 7)))
  (check-equal? (minor #b111 #b111) -3))

(test-case "cofactors are those of the adjugate: A adj A is the determinant"
  (with-seed 422
    (for ([n (in-range 1 6)])
      (define A (random-rows n 0.8))
      (define minor (make-minors number-ring A))
      (define d (determinant-by-minors A))
      (define adjugate (rows n (lambda (i j) (cofactor number-ring minor n j i))))
      (check-equal? (times A adjugate) (rows n (lambda (i j) (if (= i j) d 0)))))))

(test-case "Cramer's numerators, with the columns of right-hand sides at the end"
  (define A #(#(2 1 5 9) #(1 3 6 8)))
  (define minor (make-minors number-ring A))
  (define (numerator j k) (minor-with-column number-ring minor 2 j k))
  (check-equal? (numerator 0 2) (- (* 5 3) (* 1 6)))
  (check-equal? (numerator 1 2) (- (* 2 6) (* 5 1)))
  (check-equal? (numerator 0 3) (- (* 9 3) (* 1 8)))
  (check-equal? (numerator 1 3) (- (* 2 8) (* 9 1))))

(test-case "every minor is computed once: products are counted"
  (define count 0)
  (define counting (operations + - (lambda (a b) (set! count (add1 count)) (* a b))))
  (define (cost A)
    (set! count 0)
    (define n (vector-length A))
    ((make-minors counting A) (all-lines n) (all-lines n))
    count)
  (define (columns A)
    (for/list ([row A])
      (for/list ([x row] [j (in-naturals)] #:unless (eqv? x 0)) j)))
  (define band (rows 12 (lambda (i j) (if (<= (abs (- i j)) 1) (+ 2 i j) 0))))
  (define dense (rows 8 (lambda (i j) (+ 1 (* i i) (* 3 i j j)))))
  (check <= (cost dense) 1024)
  (check-equal? (expansion-cost (columns dense) 10000) 1024)
  (check <= (cost band) (expansion-cost (columns band) 10000))
  (check < (expansion-cost (columns band) 10000) 100)
  (check-equal? (expansion-cost (columns dense) 1024) 1024)
  (check-false (expansion-cost (columns dense) 1023)))

(test-case "the characteristic polynomial is |x - A| at any x"
  (with-seed 423
    (for* ([n (in-range 1 7)] [_ 3])
      (define A (random-rows n 0.7))
      (define p (characteristic-coefficients number-ring A))
      (for ([x '(0 1 -2 5/3)])
        (define x-A
          (rows n (lambda (i j) (- (if (= i j) x 0) (vector-ref (vector-ref A i) j)))))
        (check-equal? (for/fold ([v 0]) ([c (in-list p)]) (+ (* v x) c))
                      (Leibniz x-A))))))

(test-case "the adjugate times vectors, by Cayley and Hamilton"
  (with-seed 424
    (for ([n (in-range 1 7)])
      (define A (random-rows n))
      (define bs (for/list ([_ 2]) (for/vector ([_ n]) (random-rational))))
      (define-values (d ys) (adjugate-times number-ring A bs))
      (check-equal? d (Leibniz A))
      (for ([b (in-list bs)] [y (in-list ys)])
        (check-equal? (times A (for/vector ([x y]) (vector x)))
                      (for/vector ([x b]) (vector (* d x))))))))
