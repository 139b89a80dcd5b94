#lang racket/base
;; A row of zeros among numbers with decimals was told as another row's multiple by -inf.0, for
;; 0.0 was not taken for 0.

(require (except-in mechanics time)
         "../support/checks.rkt" "../support/messages.rkt")

(define (dependent A)
  (cadr (regexp-match #rx"dependent: ([^\n]*)" (message-of (invert A) exn:fail:mechanics?))))

(test-case "a row of zeros, wherever it is"
  (for* ([n '(2 3)] [k (in-range n)] [zero '(0 0.0)] [one '(1 1.0)])
    (define rows
      (for/list ([i (in-range n)])
        (for/list ([j (in-range n)]) (if (and (= i j) (not (= i k))) one zero))))
    (check-equal? (dependent (apply matrix-by-rows rows)) (format "row ~a is zero" k))))

(test-case "rows that are multiples are told as before"
  (check-equal? (dependent (matrix-by-rows '(1.0 2.0) '(2.0 4.0))) "row 1 is 2.0 times row 0")
  (check-equal? (dependent (matrix-by-rows '(0.0 1.0 0.0) '(1.0 0.0 0.0) '(2.0 0.0 0.0)))
                "row 2 is 2.0 times row 1"))
