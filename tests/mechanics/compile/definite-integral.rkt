#lang racket/base
;; Integrals whose integrands are compiled on the way.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/error/failure
         mechanics/calculus/derivative
         mechanics/compile/definite-integral
         (only-in mechanics/compile/compile-function compile-scalar)
         mechanics/lagrangian/local-tuple
         (only-in mechanics [< g:<])
         mechanics/value/compose
         "../support/checks.rkt")

;; 100 s of a pendulum's Lagrangian along a wiggling path: thousands of evaluations.
(define (wiggle t) (g:+ (g:sin t) (g:* 0.1 (g:cos (g:* 20 t)))))
(define (slow local)
  (g:- (g:* 1/2 (g:square (velocity local))) (g:* -9.8 (g:cos (coordinate local)))))
(define along (compose slow (Gamma wiggle)))

;; The same, which a test keeps from being traced.
(define (never-compiled x) (if (g:< x -1) 0 (along x)))

(test-case "compiled or not, the value is the same up to rounding"
  (define-values (value bound count) (definite-integral along 0 100 #:report values))
  (define-values (value* bound* count*) (definite-integral never-compiled 0 100 #:report values))
  (check-= value value* (* 1e-14 (abs value)))
  (check-= bound bound* (* 1e-6 bound))
  (check-equal? count count*))

(test-case "a function that needs many values is no longer called after some hundred"
  (define calls 0)
  (define (watched x) (set! calls (+ calls 1)) (along x))
  (define count (definite-integral watched 0 100 #:report (lambda (value bound count) count)))
  (check-true (> count 5000))
  (check-true (< calls 600)))

(test-case "flonum code of a function of one number"
  (define f (compile-scalar (lambda (x) (g:+ 1 (g:square x))) 0.0))
  (check-equal? (f 3.0) 10.0)
  (check-false (compile-scalar never-compiled 0.0) "a decision")
  (check-false (compile-scalar (lambda (x) (up x x)) 0.0) "a tuple")
  (check-false (compile-scalar (lambda (x) (g:* 'm x)) 0.0) "a symbol")
  (check-false (compile-scalar (lambda (x) (raise-argument-error 'f "another" x)) 0.0) "an error"))

(test-case "the report: value, bound of the error, evaluations"
  (define-values (value bound count) (definite-integral g:sin 0 1 #:report values))
  (check-= value (- 1 (cos 1.0)) bound)
  ;; 21 of the rule, and where a mass of small width might be
  (check-equal? count 237)
  (check-equal? (definite-integral g:sin 1 1 #:report list) '(0.0 0.0 0)))

(test-case "of several integrals, bounds and evaluations are counted together"
  (define (report f) (definite-integral f 0 1 1e-8 #:report list))
  ;; within a derivative, the integrals of the value and of the slope
  (define-values (value slope)
    (values (report (lambda (x) (g:sqrt (g:+ 2 x))))
            (report (lambda (x) (g:/ 1/2 (g:sqrt (g:+ 2 x)))))))
  (define both #f)
  ((D (lambda (a)
        (definite-integral (lambda (x) (g:sqrt (g:+ a x))) 0 1 1e-8
                           #:report (lambda (v bound count) (set! both (list bound count)) v))))
   2)
  (check-= (/ (car both) (+ (cadr value) (cadr slope))) 1 1e-6)
  (check-equal? (cadr both) (+ 1 (caddr value) (caddr slope)) "and one to see that it is dual"))

(test-case "a stricter tolerance costs more and bounds more"
  (define (report tolerance) (definite-integral-with-tolerance g:sqrt 0 1 tolerance #:report list))
  (for ([loose (map report '(1e-2 1e-4 1e-6))] [strict (map report '(1e-6 1e-9 1e-12))])
    (check-true (< (cadr strict) (cadr loose)))
    (check-true (> (caddr strict) (caddr loose)))))

;; ∫ sin(w x) from 0 to 100, and its derivative by w
(define (many w) (definite-integral (lambda (x) (g:sin (g:* w x))) 0 100))
(define (many-in-closed-form w) (g:/ (g:- 1 (g:cos (g:* 100 w))) w))

(test-case "derivatives of integrals that need many values"
  (check-= (many 20) (many-in-closed-form 20) 1e-9)
  (check-= ((D many) 20) ((D many-in-closed-form) 20) 1e-6)
  (check-= ((D (D many)) 20) ((D (D many-in-closed-form)) 20) 1e-4))

(test-case "integrals of integrals, and within threads"
  ;; the volume under 1/(1 + x y) over the unit square: π²/12
  (define (volume)
    (definite-integral
     (lambda (x) (definite-integral (lambda (y) (g:/ 1 (g:+ 1 (g:* x y)))) 0 1)) 0 1))
  (define expected (/ (expt (* 4 (atan 1.0)) 2) 12))
  (check-= (volume) expected 1e-10)
  ;; one end of the inner integral is the variable of the outer one: ∫∫ cos 40(x + y)
  (define (triangle)
    (definite-integral
     (lambda (x) (definite-integral (lambda (y) (g:cos (g:* 40 (g:+ x y)))) 0 x)) 0 3))
  (define in-closed-form
    (/ (- (/ (- 1 (cos 240.0)) 2) (- 1 (cos 120.0))) 1600.0))
  (check-= (triangle) in-closed-form 1e-9)
  (define results (make-vector 4 #f))
  (for-each thread-wait
            (for/list ([i 4])
              (thread (lambda () (vector-set! results i (definite-integral along 0 100))))))
  (for ([r results]) (check-equal? r (definite-integral along 0 100))))

(test-case "where the compiled function has no value, the error is the function's own"
  ;; a real number up to 50, complex from there on
  (define (f x) (g:* (g:sin (g:* 40 x)) (g:sqrt (g:- 50 x))))
  (check-exn #rx"^definite-integral: expected a real number\n  given: the number .*i$"
             (lambda () (definite-integral f 0 100))))

(test-case "mistakes"
  (check-equal? (definite-integral g:sin 0 'b) (g:- 1 (g:cos 'b)))
  (check-exn #rx"^definite-integral: expected a function of one variable"
             (lambda () (definite-integral (lambda (x y) x) 0 1)))
  (check-exn #rx"^definite-integral: expected a real number\n  given: .*up tuple of 2"
             (lambda () (definite-integral (lambda (x) (up x x)) 0 1)))
  (check-exn #rx"a real number, perhaps infinite, as limit of integration"
             (lambda () (definite-integral g:sin 0 +nan.0)))
  (check-exn #rx"^definite-integral: the function is not finite\n  at: 0.5"
             (lambda () (definite-integral (lambda (x) +nan.0) 0 1)))
  (for ([tolerance (list 0 -1 'a +nan.0)])
    (check-exn
     #rx"^definite-integral-with-tolerance: expected a positive tolerance"
     (lambda () (definite-integral-with-tolerance g:sin 0 1 tolerance))))
  (check-exn exn:fail:mechanics:not-convergent:integral?
             (lambda () (definite-integral (lambda (x) (g:/ 1 x)) 0 1))))
