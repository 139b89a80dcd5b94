#lang racket/base
;; Functions of structures, compiled.

(require racket/flonum
         (only-in mechanics
                  up down + - * / sin cos square sqrt ref coordinate velocity < = zero? number?
                  equal? memv member case max D partial literal-function F->C p->r
                  Lagrangian->state-derivative compile-function
                  compiled-function-reason compiled-function-operations)
         (only-in mechanics/book L-pendulum)
         mechanics/compile/cache
         "../support/checks.rkt" "../support/close.rkt")

(define (numbers v) (for/list ([x (in-flvector v)]) x))

(test-case "a state derivative"
  (define f (Lagrangian->state-derivative (L-pendulum 9.8 2 3)))
  (define c (compile-function f (up 0 0.1 0.2)))
  (check-false (compiled-function-reason c))
  (check-close (c (flvector 0.0 1.0 0.5)) (list 1.0 0.5 (* (/ -9.8 3) (sin 1.0))) 1e-12))

(test-case "structures within structures, orientation included"
  (define (f s) (up (* (ref s 0) (ref s 1)) (down (ref s 1 1) 7)))
  (define c (compile-function f (up (down 1 2) (up 3 4))))
  (check-close (c (flvector 1.0 2.0 3.0 4.0)) '(11.0 4.0 7.0) 1e-12))

(test-case "derivatives are compiled like other functions"
  (define c (compile-function (D (lambda (s) (* (sin (ref s 0)) (square (ref s 1))))) (up 1 1)))
  (check-false (compiled-function-reason c))
  (check-close (c (flvector 0.3 2.0)) (list (* 4.0 (cos 0.3)) (* 4.0 (sin 0.3))) 1e-12))

(test-case "a function that looks at its argument is not traced past that"
  (define-syntax-rule (check-decisions [x body] ...)
    (begin (check-decision x body) ...))
  (define-syntax-rule (check-decision x body)
    (let* ([f (lambda (x) body)] [c (compile-function f 2.0)])
      (check-true (string? (compiled-function-reason c)) (format "~s" 'body))
      (check-false (compiled-function-operations c))
      (for ([at (in-list '(-1.0 0.0 0.5 2.0 3.0))])
        (check-close (c (flvector at)) (list (f at)) 1e-12))))
  (check-decisions
   [x (if (< x 1) x (square x))]
   [x (if (= x 2) 5 x)]
   [x (if (zero? x) 1 (/ (sin x) x))]
   [x (if (number? x) (* 3 x) x)]
   [x (if (equal? x 2.0) 5 x)]
   [x (if (memv x '(2.0 3.0)) 5 x)]
   [x (if (member x '(2.0 3.0)) 5 x)]
   [x (case x [(3.0) 5] [else x])]
   [x (max x 1)]
   [x (vector-ref (vector 1 2 3 4) (abs (inexact->exact (floor x))))]))

(test-case "the reason names the test"
  (check-regexp-match #rx"decision by `<`"
                      (compiled-function-reason
                       (compile-function (lambda (x) (if (< (sin x) 1) x 0)) 2.0))))

(test-case "constants are not combined beyond the flonums"
  (define (f x) (* 1e200 (- (* 1e200 x) (* 5e199 x))))
  (define c (compile-function f 1.0))
  (check-false (compiled-function-reason c))
  (check-= (/ (car (numbers (c (flvector 1e-250)))) 5e149) 1 1e-14)
  (define (g x) (* 1e-200 (+ (* 1e-200 x) (* 5e-201 x))))
  (check-= (/ (car (numbers ((compile-function g 1.0) (flvector 1e300)))) 1.5e-100) 1 1e-14))

;; 1/3 of x and 1/7 of it are one multiple in the code, and two in the function.
(test-case "rounding of great values, of either sign, is no difference"
  (define (f x) (- (+ (* 1/3 x) (* 1/7 x)) (* 1/11 (square x))))
  (for ([x '(1e9 -1e9)]) (check-false (compiled-function-reason (compile-function f x)))))

(test-case "Racket's own tests are found out by the value at the example"
  (define (f x) (if (flonum? x) (* 2 x) x))
  (define c (compile-function f 2.0))
  (check-true (string? (compiled-function-reason c)))
  (check-equal? (numbers (c (flvector 4.0))) '(8.0))
  (define both (compile-function (lambda (x) (up x (f x))) 2.0))
  (check-true (string? (compiled-function-reason both)))
  (check-equal? (numbers (both (flvector 4.0))) '(4.0 8.0)))

(test-case "a changed global is seen by what is compiled again; the same program is compiled once"
  (define k 2)
  (define (f x) (* k x))
  (define before (compile-function f 1.0))
  (set! k 3)
  (define after (compile-function f 1.0))
  (check-equal? (numbers (before (flvector 5.0))) '(10.0))
  (check-equal? (numbers (after (flvector 5.0))) '(15.0))
  (clear-compiled-programs)
  (check-equal? (numbers ((compile-function f 1.0) (flvector 5.0))) '(15.0)))

(test-case "mistakes"
  (check-exn #rx"compile-function: .*a function of one structure"
             (lambda () (compile-function 3 1.0)))
  (check-exn #rx"compile-function: the example holds the symbol x"
             (lambda () (compile-function sin (up 1 'x))))
  (check-exn #rx"the symbol m is left in the function's value.*give every symbol a number"
             (lambda () (compile-function (lambda (x) (* 'm x)) 1.0)))
  (check-exn #rx"\\(V x0\\).*has no numeric value"
             (lambda () (compile-function (literal-function 'V) 1.0)))
  (check-exn #rx"the value holds \"no\", a string"
             (lambda () (compile-function (lambda (x) "no") 1.0)))
  (check-exn #rx"another length.*expected: 2.*given: 1"
             (lambda () ((compile-function (lambda (s) (ref s 0)) (up 1 2)) (flvector 1.0))))
  (check-exn #rx"flvector"
             (lambda () ((compile-function (lambda (s) (ref s 0)) (up 1 2)) (up 1 2)))))

(test-case "an error of the function's own is raised when it is compiled"
  (check-exn #rx"ref: index 5" (lambda () (compile-function (lambda (s) (ref s 5)) (up 1 2)))))

(test-case "it prints as what was typed"
  (define (f x) x)
  (check-equal? (format "~a" (compile-function f 1.0)) "(compile-function f)"))
