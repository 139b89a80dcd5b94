#lang racket/base
;; Compiled programs that are kept: served to the same program, and to no other.

(require racket/flonum
         (only-in mechanics up + * sin compile-function compiled-function-reason)
         mechanics/compile/cache
         mechanics/compile/program
         "../support/checks.rkt")

;; The outputs of x ↦ c x and x + c x that are asked for, at 5.0.
(define (outputs c . places)
  (define p
    (program 1
             (vector (list 'multiply c (place 0)) (list 'add (place 0) (place 1)))
             (list->vector (map place places))))
  (define output (make-flvector (length places)))
  (((compiled-program p)) (flvector 5.0) output)
  (for/list ([x (in-flvector output)]) x))

(test-case "programs of equal instructions and other outputs are others"
  (clear-compiled-programs)
  (check-equal? (outputs 2.0 1 2) '(10.0 15.0))
  (check-equal? (outputs 2.0 2 1) '(15.0 10.0))
  (check-equal? (outputs 2.0 2) '(15.0))
  (check-equal? (outputs 2.0 1) '(10.0))
  (check-equal? (outputs 3.0 1 2) '(15.0 20.0))
  (check-equal? (compiled-program-count) 5))

(test-case "so are functions whose values differ in order, both compiled"
  (clear-compiled-programs)
  (define ((values-of combine) x) (let ([s (sin x)]) (combine s (* s s))))
  (for ([combine (list up (lambda (s s2) (up s2 s)) (lambda (s s2) (up s2 s s2)))])
    (define f (values-of combine))
    (define c (compile-function f 1.0))
    (check-false (compiled-function-reason c))
    (check-equal? (for/list ([x (in-flvector (c (flvector 0.5)))]) x)
                  (let ([v (f 0.5)]) (for/list ([x v]) x)))))

(test-case "the same program is compiled once, as long as it is among the last few"
  (define (program-of c) (program 1 (vector (list 'multiply c (place 0))) (vector (place 1))))
  (clear-compiled-programs)
  (define first (compiled-program (program-of 1.5)))
  (check-eq? (compiled-program (program-of 1.5)) first)
  (check-equal? (compiled-program-count) 1)
  (for ([k 31]) (compiled-program (program-of (+ 2.0 k))))
  (check-equal? (compiled-program-count) 32)
  (check-eq? (compiled-program (program-of 1.5)) first)
  (for ([k 32]) (compiled-program (program-of (+ 50.0 k))))
  (check-equal? (compiled-program-count) 32)
  (check-false (eq? (compiled-program (program-of 1.5)) first)))
