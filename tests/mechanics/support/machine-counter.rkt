#lang racket/base
;; A procedure of machine code that counts, here and in a place that ends while it does.

(require racket/flonum
         racket/place
         mechanics/numeric/machine/assembler
         "machine-run.rkt")

(provide make-counter count-to count-in-place count-and-end)

;; -> (flvector flvector -> void), which makes the second number one more than the first; or #f
(define (make-counter)
  (machine-run
   (lambda (a)
     (movsd! a 0 (behind rdi 0))
     (addsd! a 0 (constant 1.0))
     (store-sd! a (behind rsi 0) 0)
     (ret! a))))

(define (count-to n counter)
  (define v (flvector 0.0))
  (for ([_ (in-range n)]) (counter v v))
  (flvector-ref v 0))

;; -> 10.0, counted in a place
(define (count-in-place)
  (define p
    (dynamic-place (variable-reference->module-source (#%variable-reference)) 'count-and-end))
  (begin0 (place-channel-get p)
          (place-wait p)))

;; In a place: a thread counts on when it ends.
(define (count-and-end end)
  (define counter (make-counter))
  (thread (lambda () (count-to +inf.0 counter)))
  (sleep 0.02)
  (place-channel-put end (count-to 10 counter))
  (exit 0))
