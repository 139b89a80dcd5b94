#lang racket/base
;; Limits of sequences (P. Wynn, 1956): from S₀, S₁ …
;;
;;     ε(n, j+1) = ε(n−1, j−1) + 1/(ε(n, j) − ε(n−1, j)),   ε(n, −1) = 0,  ε(n, 0) = Sₙ,
;;
;; in which ε(n, 2m) is the limit of sums of m geometric sequences, and near it for many
;; others.  A sequence's *diagonal* is (ε(n, 0) ε(n−1, 1) …); it begins empty.

(provide extend-diagonal estimated-limit)

(define most-columns 16)

;; The diagonal one term later.
(define (extend-diagonal diagonal s)
  (let loop ([new s] [old diagonal] [older 0.0] [column 0])
    (define difference (if (null? old) 0.0 (- new (car old))))
    (cons new
          (if (or (= difference 0.0) (= column most-columns))
              '()
              (loop (+ older (/ 1.0 difference)) (cdr old) (car old) (+ column 1))))))

;; Its last entry in an even column.
(define (estimated-limit diagonal)
  (if (or (null? (cdr diagonal)) (null? (cddr diagonal)))
      (car diagonal)
      (estimated-limit (cddr diagonal))))
