#lang racket/base
;; Of two rows the smaller eigenvalue lost its digits where its row stood first: of
;; (-1e-7 2; 1 -1e8) it was off by 12 %, of the same rows in the other order exact.

(require mechanics "../support/checks.rkt")

;; The product of both is a d − b c, the sum nearly the larger one.
(define-check (check-smaller rows expected)
  (define found (sort (eigenvalues (apply matrix-by-rows rows)) < #:key magnitude))
  (unless (<= (abs (- (/ (car found) expected) 1)) 1e-14)
    (with-check-info (['rows rows] ['eigenvalues found] ['smaller expected]) (fail-check))))

(test-case "the smaller eigenvalue has its digits in either order of rows"
  (check-smaller '((-1e-7 2.0) (1.0 -1e8)) -8e-8)
  (check-smaller '((-1e8 1.0) (2.0 -1e-7)) -8e-8)
  (check-smaller '((1e-7 2.0) (1.0 1e8)) 8e-8)
  (check-smaller '((1e-7 -2.0) (-1.0 -1e8)) 1.2e-7))

(test-case "where one entry beside the diagonal is zero, those on it are the eigenvalues"
  (check-equal? (sort (eigenvalues (matrix-by-rows '(1e-9 0.0) '(1.0 1e9))) <) '(1e-9 1e9))
  (check-equal? (sort (eigenvalues (matrix-by-rows '(1e-9 3.0) '(0.0 -1e9))) <) '(-1e9 1e-9)))
