#lang racket/base
;; Racket's vector procedures on tuples.

(require mechanics "../support/checks.rkt")

(test-case "tuples are accepted where the book says vector"
  (check-equal? (vector-ref (up 1 'q 3) 1) 'q)
  (check-equal? (vector-length (down 1 2)) 2))

(test-case "a function of corresponding components has the shape of the first tuple"
  (check-equal? (vector-map - (down 5 7) (vector 1 'x)) (down 4 (- 7 'x)))
  (check-equal? (vector-map * (vector 2 3) (up 4 5)) (vector 8 15))
  (check-exn #rx"^vector-map: the tuples differ in length: [(]2 3[)]$"
             (lambda () (vector-map + (up 1 2) (up 1 2 3)))))

(test-case "vectors are treated as ever"
  (check-equal? (vector-ref (vector 1 2) 1) 2)
  (check-equal? (vector-length #(1 2 3)) 3))

(test-case "what is neither is refused in Racket's words"
  (check-exn #rx"vector-ref: contract violation.*given: '\\(1 2\\)"
             (lambda () (vector-ref '(1 2) 0)))
  (check-exn #rx"vector-ref: index is out of range"
             (lambda () (vector-ref (up 1 2) 2))))
