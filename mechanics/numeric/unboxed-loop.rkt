#lang racket/base
;; Loops over flonums, whose indices are not checked.
;;
;; The compiler keeps the sums of a loop in registers if operations alone use them.  A sum that is
;; returned as it is, or handed to a procedure, is made an object in memory at every turn instead;
;; as the value of an operation it is made one once.

(require racket/unsafe/ops)

(provide unboxed each at put! sum)

(define-syntax-rule (unboxed x) (unsafe-fl* 1.0 x))

;; For each index from one on and before another
(define-syntax-rule (each (i from to) body ...)
  (let ([end to])
    (let loop ([i from])
      (when (unsafe-fx< i end)
        body ...
        (loop (unsafe-fx+ i 1))))))

(define-syntax-rule (at v i) (unsafe-flvector-ref v i))
(define-syntax-rule (put! v i x) (unsafe-flvector-set! v i x))

;; From the left.
(define-syntax sum
  (syntax-rules ()
    [(_ x) x]
    [(_ x y . more) (sum (unsafe-fl+ x y) . more)]))
