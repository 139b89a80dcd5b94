#lang racket/base
;; Systems of equations in machine code: the solutions of numeric/linear-algebra, bit for bit.

(require racket/fixnum
         racket/flonum
         mechanics/numeric/linear-algebra/factored-system
         mechanics/numeric/linear-algebra/symmetric-system
         mechanics/numeric/machine/executable
         mechanics/numeric/machine/straight-code
         mechanics/numeric/machine/straight-instruction
         "../../support/checks.rkt"
         "../../support/machine-run.rkt" "../../support/random.rkt" "../../support/skip.rkt")

;; -> a procedure of [A b], row by row, and of the solution; of a symmetric A the upper triangle
;; alone is read
(define (machine-solver n symmetric?)
  (define width (+ n 1))
  (define (entry i j) (place (if (and symmetric? (> i j)) (+ (* j width) i) (+ (* i width) j))))
  (define instructions
    (list->vector
     (cons (cons 'solve (for*/list ([i n] [j width]) (entry i j)))
           (for/list ([k n]) (list 'component (place (* n width)) k)))))
  (define outputs (for/vector ([k n]) (place (+ (* n width) 1 k))))
  (machine-run (lambda (a) (write-procedure! a (* n width) 0 instructions outputs))))

(define (by-machine run A b n)
  (define system
    (for*/flvector ([i n] [j (+ n 1)])
      (if (= j n) (flvector-ref b i) (flvector-ref A (+ (* i n) j)))))
  (define x (make-flvector n))
  (run system x)
  x)

(define (by solve! A b n)
  (define x (flvector-copy b))
  (solve! (flvector-copy A) n (make-fxvector n) x)
  x)

;; BᵀB of the rank, with the shift on the diagonal
(define (product-with-itself n rank shift)
  (define B (for/vector ([_ (* n rank)]) (- (random) 0.5)))
  (for*/flvector ([i n] [j n])
    (for/fold ([sum (if (= i j) shift 0.0)]) ([k rank])
      (+ sum (* (vector-ref B (+ (* k n) i)) (vector-ref B (+ (* k n) j)))))))

(define (random-entries n) (for/flvector ([_ n]) (- (random) 0.5)))

(define (check-solvers n)
  (define symmetric (machine-solver n #t))
  (define general (machine-solver n #f))
  (with-check-info (['n n])
    (for ([A (list (product-with-itself n n 0.1) (product-with-itself n n 10.0)    ; definite
                   (product-with-itself n n -0.5) (product-with-itself n n -20.0)
                   (product-with-itself n (- n 1) 0.0) (make-flvector (* n n)))])
      (define b (random-entries n))
      (check-equal? (by-machine symmetric A b n) (by solve-symmetric! A b n)))
    (for ([A (list (random-entries (* n n)) (make-flvector (* n n) 1.0))])
      (define b (random-entries n))
      (check-equal? (by-machine general A b n) (by solve-dense! A b n)))))

(skip-unless (machine?) "no processor that machine code is written for"
  (test-case "definite, indefinite, nearly singular and singular ones, of every size"
    (with-seed 43
      (for ([n (in-list '(1 2 3 5 8 9 11 12 14 16 17 18 20 23))]) (check-solvers n)))))
