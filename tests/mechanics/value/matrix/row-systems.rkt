#lang racket/base
;; The algorithms under determinants and systems, on vectors of rows.

(require mechanics/generic/arithmetic
         mechanics/error/failure
         mechanics/value/matrix/row-systems
         "../../support/checks.rkt" "../../support/random.rkt" "../../support/same.rkt")

(define (rows n entry)
  (for/vector ([i n]) (for/vector ([j n]) (entry i j))))

;; Σ over permutations of sign times product: the definition.
(define (Leibniz rows)
  (define n (vector-length rows))
  (let loop ([i 0] [columns (for/list ([j n]) j)])
    (if (= i n)
        1
        (for/fold ([sum 0]) ([j (in-list columns)] [k (in-naturals)])
          (g:+ sum (g:* (if (even? k) 1 -1)
                        (vector-ref (vector-ref rows i) j)
                        (loop (add1 i) (remv j columns))))))))

(test-case "determinants are what the definition says, by both algorithms"
  (with-seed 331
    (for* ([n (in-range 6)] [_ 3])
      (define numbers (rows n (lambda (i j) (random-integer -3 3))))
      (check-equal? (rows-determinant numbers) (Leibniz numbers))
      (define symbols
        (rows n (lambda (i j) (if (zero? (random 3)) 0 (string->symbol (format "a~a~a" i j))))))
      (check-true (same? (rows-determinant symbols) (Leibniz symbols))))))

(test-case "a singular matrix of integers has determinant exactly zero"
  (check-eqv? (rows-determinant (rows 4 (lambda (i j) (+ i j)))) 0))

(test-case "a minor is computed once: 12 by 12 symbols are no problem"
  (define d (rows-determinant (rows 12 (lambda (i j) (if (<= (abs (- i j)) 1) 'a 0)))))
  (check-true (same? d (for/fold ([p 1] [q 'a] #:result q) ([_ 11])
                         (values q (g:- (g:* 'a q) (g:* 'a 'a p)))))))

(test-case "transposition exchanges rows and columns"
  (check-equal? (rows-transpose (vector (vector 1 2 3) (vector 4 5 6)))
                (vector (vector 1 4) (vector 2 5) (vector 3 6)))
  (check-equal? (rows-transpose (vector)) (vector)))

(test-case "the arguments are left as they were"
  (define A (rows 3 (lambda (i j) (/ 1 (+ i j 1)))))
  (define b (vector 1 2 3))
  (define x (rows-solve (quote test) A A b))
  (rows-determinant A)
  (check-equal? A (rows 3 (lambda (i j) (/ 1 (+ i j 1)))))
  (check-equal? b (vector 1 2 3))
  (check-equal? (for/vector ([row A]) (for/sum ([a row] [y x]) (* a y))) b))

(test-case "a singular system raises, naming the caller"
  (check-exn (lambda (e)
               (and (exn:fail:mechanics:singular? e)
                    (regexp-match? #rx"^caller: the matrix has no inverse" (exn-message e))
                    (equal? (exn:fail:mechanics:singular-where e) (rows 2 (lambda (i j) 1)))))
             (lambda ()
               (rows-solve (quote caller)
                           (rows 2 (lambda (i j) 1))
                           (rows 2 (lambda (i j) 1))
                           (vector 1 2)))))
