#lang racket/base
;; Racket's vector procedures on tuples.

(require mechanics "../support/checks.rkt")

(test-case "tuples are accepted where the book says vector"
  (check-equal? (vector-ref (up 1 'q 3) 1) 'q)
  (check-equal? (vector-length (down 1 2)) 2))

(test-case "vectors are treated as ever"
  (check-equal? (vector-ref (vector 1 2) 1) 2)
  (check-equal? (vector-length #(1 2 3)) 3))

(test-case "what is neither is refused in Racket's words"
  (check-exn #rx"vector-ref: contract violation.*given: '\\(1 2\\)"
             (lambda () (vector-ref '(1 2) 0)))
  (check-exn #rx"vector-ref: index is out of range"
             (lambda () (vector-ref (up 1 2) 2))))
