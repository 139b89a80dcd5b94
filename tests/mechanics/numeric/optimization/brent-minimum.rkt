#lang racket/base
;; Brent's minimiser.

(require mechanics/error/failure
         mechanics/numeric/optimization/brent-minimum
         "../../support/checks.rkt")

(define (argument result) (car result))
(define (value result) (cadr result))
(define (steps result) (caddr result))

(test-case "the factor of the varied action, SICM p. 19: argument 0, value 435, 5 steps"
  ;; S(ε) = 435 + 1291214.285714… ε², with 435 + 18077/14000 at ε = 1/1000.
  (define (action epsilon) (+ 435.0 (* 18077/14000 1e6 epsilon epsilon)))
  (define result (minimize action -2 1))
  (check-= (argument result) 0.0 1e-12)
  (check-= (value result) 435.0 1e-12)
  (check-equal? (steps result) 5))

(test-case "a quadratic function takes about five steps wherever its minimum is"
  (for ([c '(-1.9 -1 -1/3 0 1/7 0.9)])
    (define result (minimize (lambda (x) (+ 1 (* 5 (- x c) (- x c)))) -2 1))
    (check-= (argument result) c 1e-9)
    (check-true (<= 4 (steps result) 8) (format "~a: ~a" c result))))

(test-case "smooth functions, to the square root of the rounding error"
  (check-= (argument (minimize cos 0 6)) 3.141592653589793 3e-8)
  (check-= (argument (minimize (lambda (x) (+ (exp x) (exp (* -2 x)))) -3 4))
           (/ (log 2.0) 3) 1e-8)
  (check-= (argument (minimize (lambda (x) (* x (log x))) 1e-6 1)) (exp -1.0) 1e-8))

(test-case "flat, kinked and constant functions end"
  (check-= (argument (minimize (lambda (x) (expt (- x 1/3) 4)) -2 1)) 1/3 1e-3)
  (check-= (argument (minimize abs -2 1)) 0.0 1e-8)
  (check-equal? (value (minimize (lambda (x) 7) 0 1)) 7.0))

(test-case "without a minimum inside, the end is approached"
  (check-= (argument (minimize values 0 1)) 0.0 1e-8)
  (check-= (argument (minimize - 0 1)) 1.0 1e-7))

(test-case "the ends may come in either order or coincide"
  (check-equal? (minimize cos 6 0) (minimize cos 0 6))
  (check-equal? (minimize cos 2 2) (list 2.0 (cos 2.0) 0)))

(test-case "a wider tolerance takes fewer steps"
  (define (f x) (- (cos x) (* 0.01 x)))
  (check-true (< (steps (minimize f 0 6 #:tolerance 1e-2))
                 (steps (minimize f 0 6)))))

(test-case "too few steps are a failure that carries the best argument"
  (define failure
    (with-handlers ([exn:fail:mechanics:not-convergent? values])
      (minimize cos 0 6 #:limit 3)))
  (check-regexp-match #rx"^minimize: no minimum found\n  steps: 3\n  best value: "
                      (exn-message failure))
  (check-= (exn:fail:mechanics:not-convergent-value failure) 3.14 0.5))

(test-case "wrong arguments are refused by name"
  (check-exn #rx"minimize: the function must give real numbers; does it still contain symbols[?]"
             (lambda () (minimize (lambda (x) 'm) 0 1)))
  (check-exn #rx"minimize: expected a finite real number as end"
             (lambda () (minimize cos 'a 1)))
  (check-exn #rx"minimize: the function is not finite\n  at: "
             (lambda () (minimize (lambda (x) +nan.0) 0 1))))
