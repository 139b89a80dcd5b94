#lang racket/base
;; Systems solved by machine code have the solutions of numeric/linear-algebra/, bit for bit.

(require racket/fixnum
         racket/flonum
         mechanics/numeric/linear-algebra/factored-system
         mechanics/numeric/linear-algebra/symmetric-system
         mechanics/numeric/machine/executable
         mechanics/numeric/machine/straight-code
         mechanics/numeric/machine/straight-instruction
         "../../support/checks.rkt" "../../support/machine-run.rkt" "../../support/random.rkt"
         "../../support/skip.rkt")

(define kinds
  '(definite definite-but-late dominant indefinite singular hardly-definite odd asymmetric))
;; A system of one unknown is symmetric.
(define (symmetric? n kind) (or (= n 1) (not (memq kind '(dominant asymmetric)))))

(define odd-numbers
  '(0.0 -0.0 1.0 -1.0 +inf.0 -inf.0 +nan.0 1e300 1e-310 0.5 2.0 3.0 -3.0 1e22 -2.5))

;; -> a procedure of [A b], row by row, that stores the solution; of a symmetric system only the
;; entries of A from the diagonal on are read
(define (machine-solver n kind)
  (define size (* n (+ n 1)))
  (define (entry i j)
    (place (if (and (< j i) (symmetric? n kind)) (+ i (* j (+ n 1))) (+ j (* i (+ n 1))))))
  (define instructions
    (cons (cons 'solve (for*/list ([i n] [j (+ n 1)]) (entry i j)))
          (for/list ([j n]) (list 'component (place size) j))))
  (machine-run
   (lambda (a)
     (write-procedure! a size 0 (list->vector instructions)
                       (for/vector ([j n]) (place (+ 1 j size)))))))

(define (random-entry n kind i j)
  (define diagonal? (= i j))
  (case kind
    [(definite dominant) (if diagonal? (+ n (random)) (- (random) 0.5))]
    [(definite-but-late) (if diagonal? (if (= i (- n 2)) -1.0 (+ n (random))) (- (random) 0.5))]
    [(singular) (if (= j n) 1.0 (fl* (->fl i) (->fl j)))]
    ;; elimination of row 0 leaves 10⁻¹³ or so of the diagonal, and else nothing
    [(hardly-definite)
     (* (if (= j n) 1.0 (* (+ i 1.0) (+ j 1.0)))
        (if (and diagonal? (> i 0)) (+ 1.0 (* 1e-13 (+ 0.9 (random)))) 1.0))]
    [(odd) (if (zero? (random 5)) (apply random-choice odd-numbers) (random-flonum))]
    [else (random-flonum)]))

;; The solution by numeric/linear-algebra/
(define (solution n kind input)
  (define (at i j) (flvector-ref input (+ j (* i (+ n 1)))))
  (define A
    (for*/flvector ([i n] [j n]) (if (and (< j i) (symmetric? n kind)) (at j i) (at i j))))
  (define b (for/flvector ([i n]) (at i n)))
  ((if (symmetric? n kind) solve-symmetric! solve-dense!) A n (make-fxvector n) b)
  b)

(define (check-systems n kind)
  (define solve! (machine-solver n kind))
  (with-seeds 6
    (define input (for*/flvector ([i n] [j (+ n 1)]) (random-entry n kind i j)))
    (define x (make-flvector n 99.0))
    (solve! input x)
    (with-check-info (['n n] ['kind kind] ['input input])
      (check-equal? x (solution n kind input)))))

(skip-unless (machine?) "no processor that machine code is written for"
  (test-case "systems of every size and kind, well posed, singular and of odd numbers"
    (for* ([n (in-list '(1 2 3 4 7 8 9 10 13 14 15 16 17 20 24 41))] [kind (in-list kinds)])
      (check-systems n kind))))
