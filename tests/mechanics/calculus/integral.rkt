#lang racket/base
;; Integrals of generic functions, and derivatives through them.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/error/failure
         mechanics/value/compose
         mechanics/value/structure
         mechanics/calculus/derivative
         mechanics/compile/definite-integral
         mechanics/lagrangian/local-tuple
         "../support/checks.rkt" "../support/notes.rkt")

(test-case "definite integrals of functions made by arithmetic"
  (check-= (definite-integral (g:square g:sin) 0 1) (/ (- 1 (* (sin 1.0) (cos 1.0))) 2) 1e-12)
  (check-= (definite-integral (D g:exp) 0 1) (- (exp 1.0) 1) 1e-12)
  (check-= (definite-integral (compose g:square velocity (Gamma g:sin)) 0 1)
           (/ (+ 1 (* (sin 1.0) (cos 1.0))) 2) 1e-12))

;; ∫ e^(−k (x − c)²) dx = √(π/k), but for the ends.  The sum of products has a turning point at c
;; as (x − c)² has a zero, and no factor has.
(test-case "a peak is found where the formula turns, however narrow"
  (define-values (k c) (values 1e12 0.00321))
  (define (square-expanded x) (g:+ (g:* x (g:- x (* 2 c))) (* c c)))
  (for ([u (list square-expanded (lambda (x) (g:square (g:- x c))))])
    (check-= (definite-integral (lambda (x) (g:exp (g:* (- k) (u x)))) -0.3 1 1e-6)
             (sqrt (/ (acos -1.0) k)) 1e-12)))

;; ---------------------------------------------------------------------------
;; Derivatives

(define (integral-of-exp a b) (definite-integral (lambda (x) (g:* a (g:exp (g:* b x)))) 0 1))
(define (closed-form a b) (g:* a (g:/ (g:- (g:exp b) 1) b)))

;; Both limit and integrand depend on a.
(define (moving a) (definite-integral (lambda (x) (g:sin (g:* a x))) 0 a))
(define (moving-in-closed-form a) (g:/ (g:- 1 (g:cos (g:* a a))) a))

(test-case "the derivative of an integral is the integral of the derivative"
  (check-= ((D (lambda (b) (integral-of-exp 1 b))) 0.3)
           ((D (lambda (b) (closed-form 1 b))) 0.3) 1e-10)
  (check-= (s:ref ((D integral-of-exp) 1.5 0.3) 1) (s:ref ((D closed-form) 1.5 0.3) 1) 1e-10))

(test-case "derivatives through an integral nest, in either order"
  (define expected (((partial 0) ((partial 1) closed-form)) 1.5 0.3))
  (check-= (((partial 0) ((partial 1) integral-of-exp)) 1.5 0.3) expected 1e-10)
  (check-= (((partial 1) ((partial 0) integral-of-exp)) 1.5 0.3) expected 1e-10)
  (check-= (((partial 1) ((partial 1) integral-of-exp)) 1.5 0.3)
           (((partial 1) ((partial 1) closed-form)) 1.5 0.3) 1e-10))

(test-case "a derivative within the integrand is not taken for the one outside"
  (define (f a)
    (definite-integral (lambda (x) ((D (lambda (y) (g:sin (g:* a y)))) x)) 0 1))
  (check-= ((D f) 1.5) (cos 1.5) 1e-10))

(test-case "by a limit the derivative is the integrand"
  (check-= ((D (lambda (b) (definite-integral g:sin 0 b))) 1.0) (sin 1.0) 1e-12)
  (check-= ((D (lambda (b) (definite-integral g:sin b 2))) 1.0) (- (sin 1.0)) 1e-12)
  (check-= ((D (D (lambda (b) (definite-integral g:sin 0 b)))) 1.0) (cos 1.0) 1e-12))

(test-case "by a parameter of integrand and limit it is the sum of both"
  (check-= ((D moving) 1.0) ((D moving-in-closed-form) 1.0) 1e-10)
  (check-= ((D (D moving)) 1.0) ((D (D moving-in-closed-form)) 1.0) 1e-10))

(test-case "an integrand that is dual in places only is integrated all the same"
  (define (f a)
    (definite-integral (lambda (x) (if (< x 1/2) x (g:* a x))) 0 1 1e-6))
  (check-= ((D f) 2.0) 3/8 1e-5))

;; ---------------------------------------------------------------------------
;; Failures

(test-case "what is no number, or no function, is refused"
  (check-exn #rx"^definite-integral: expected a real number\n  given: [(]up 0.*an up tuple of 2"
             (lambda () (definite-integral (lambda (t) (up t t)) 0 1)))
  (check-equal? (format "~a" ((D (lambda (a) (definite-integral (lambda (x) (g:* a 'm x)) 0 1))) 1))
                "(* 1/2 m)")
  (check-exn #rx"^definite-integral: expected a function of one variable"
             (lambda () (definite-integral 3 0 1))))

(test-case "a divergent integral is a mathematical failure"
  (check-exn exn:fail:mechanics? (lambda () (definite-integral (lambda (t) (g:/ 1 t)) 0 1))))

(test-case "derivatives of integrals to infinity and over singularities"
  ;; d/da of the integral of exp(-a x)/sqrt(x), sqrt(pi/a), at 2
  (define (laplace a)
    (definite-integral (lambda (x) (g:/ (g:exp (g:* -1 a x)) (g:sqrt x))) 0 +inf.0))
  (define root-of-pi (sqrt (* 4.0 (atan 1.0))))
  (check-= (laplace 2) (/ root-of-pi (sqrt 2.0)) 1e-10)
  (check-= ((D laplace) 2) (* -1/2 root-of-pi (expt 2.0 -3/2)) 1e-10)
  (check-= (((g:expt D 2) laplace) 2) (* 3/4 root-of-pi (expt 2.0 -5/2)) 1e-10)
  (check-= ((D (lambda (b) (definite-integral (lambda (x) (g:/ 1 (g:sqrt x))) 0 b))) 4) 1/2 1e-12))

;; ---------------------------------------------------------------------------
;; Integrands that were 0 wherever they were looked at

(define (take-two f)
  (definite-integral f 0 1 #:report (lambda (value bound count) (list value bound))))

(test-case "a narrow peak is found by its place in the formula, however that is written"
  (define (check-peak u)
    (check-= (definite-integral (lambda (x) (g:exp (g:negate (g:square (u x))))) 0 1 1e-6)
             (* 1e-9 (sqrt (acos -1.0))) 1e-15))
  (check-peak (lambda (x) (g:* 1e9 (g:- x 0.3123))))
  (check-peak (lambda (x) (g:/ (g:- x 0.3123) 1e-9)))
  (check-peak (lambda (x) (g:- (g:/ (g:+ x 1) 1e-9) 13123e5))))

(test-case "the bound of an integral of which nothing was seen is infinite, and a note tells"
  (define ((narrow f) x) (g:exp (g:negate (g:square (g:* 1e8 (g:- (f x) 0.3))))))
  (define (beyond x) (if (< 0.31 x 0.3100001) 1.0 0.0))
  (for ([f (list (narrow g:sin) beyond)])
    (check-equal? (told (check-equal? (take-two f) '(0.0 +inf.0)))
                  (string-append
                   "; definite-integral: the integrand was 0 at all points where it was looked at;\n"
                   ";   of a peak between them, ends next to it give the integral\n")))
  (check-exn #rx"numbers next to each other are too far apart there\n  trouble near: 0.29999999"
             (lambda () (take-two (narrow values))))
  (check-equal? (told (check-equal? (take-two (lambda (x) 0)) '(0.0 0.0))
                      (check-equal? (definite-integral beyond 0.3 0.3) 0.0)
                      (definite-integral g:sin -1 1)
                      (definite-integral (lambda (x) (+ 1 (definite-integral beyond 0 x))) 0 1))
                ""))
