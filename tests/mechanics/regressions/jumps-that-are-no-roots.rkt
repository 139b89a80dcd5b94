#lang racket/base
;; `find-root` gave the place of a jump as a root; of poles it knew.

(require mechanics "../support/checks.rkt" "../support/messages.rkt")

(define (step x) (if (< x 0.5) -1 1))
(define (uneven x) (if (< x 1/3) (- x 2) (exp x)))
(define (stairs x) (- (floor (* 3 x)) 1/2))
(define ((root-of degree) x)
  (define u (- x 0.3))
  (if (< u 0) (- (expt (- u) (/ 1.0 degree))) (expt u (/ 1.0 degree))))

(test-case "a jump is no root, from either side"
  (check-message
   (string-append
    "find-root: the function changes its sign at a jump, not at a zero; bisect finds jumps\n"
    "  near: 0.49999999999999994\n"
    "  value to the left: -1.0\n"
    "  value to the right: 1.0")
   (find-root step 0 1)
   exn:fail:mechanics:singular?)
  (for ([f (list step uneven stairs)])
    (check-exn #rx"^find-root: .* at a jump" (lambda () (find-root f 0 1)))
    (check-exn #rx"^find-root: .* at a jump" (lambda () (find-root f 1 0)))
    (check-exn #rx"^find-root: .* at a jump" (lambda () (find-root (lambda (x) (- (f x))) 0 1)))))

(test-case "bisect finds it nevertheless"
  (check-within (bisect step 0 1) 0.5 1e-14)
  (check-within (bisect uneven 0 1) 1/3 1e-14))

(test-case "what is steep, or coarse, has its root"
  (for ([degree '(1 3 9 15)]) (check-within (find-root (root-of degree) 0 1) 0.3 1e-9))
  (check-within (find-root (lambda (x) (atan (* 1e14 (- x 0.7)))) 0 1) 0.7 1e-12)
  (check-within (find-root (lambda (x) (atan (* 1e14 (- x 0.7)))) 1 0) 0.7 1e-15)
  (check-within (find-root (lambda (x) (- (+ 1e9 x) (+ 1e9 0.25))) 0 1) 0.25 1e-6)
  (check-within (find-root (lambda (x) (- (exp (* 50 x)) 3)) -1 1) (/ (log 3) 50) 1e-12))
