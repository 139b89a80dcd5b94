#lang racket/base
;; Integrals to infinity and over singularities at ends.

(require mechanics/error/failure
         mechanics/numeric/quadrature/improper
         mechanics/numeric/quadrature/oscillating
         mechanics/numeric/quadrature/periods
         "../../support/checks.rkt")

(define pi (* 4.0 (atan 1.0)))
(define (integral f low high)
  (define-values (value bound) (improper-quadrature f low high))
  value)

(define-check (check-integral f low high expected)
  (define value (integral f low high))
  (unless (<= (abs (- value expected)) (* 1e-11 (max 1.0 (abs expected))))
    (with-check-info (['value value] ['expected expected]) (fail-check))))

(test-case "powers and logarithms that are infinite at an end"
  (for ([p (in-list '(-0.2 -1/2 -2/3 -0.9))])
    (check-integral (lambda (x) (expt x p)) 0 1 (/ 1.0 (+ p 1)))
    (check-integral (lambda (x) (expt (- 1.0 x) p)) 0 1 (/ 1.0 (+ p 1))))
  (check-integral log 0 1 -1.0)
  (check-integral (lambda (x) (expt (log x) 2)) 0 1 2.0)
  (check-integral (lambda (x) (/ (log x) (sqrt x))) 0 1 -4.0)
  (check-integral (lambda (x) (/ 1.0 (sqrt (- 1.0 (* x x))))) -1 1 pi))

(test-case "the period of a pendulum, from an integrand infinite at both turning points"
  (define (slowness x) (/ 2.0 (sqrt (* 2.0 9.8 (- (cos x) (cos 1.0))))))
  (check-integral slowness -1 1 2.140228719018093))

(test-case "ranges without an end"
  (define (bell x) (exp (- (* x x))))
  (check-integral bell -inf.0 +inf.0 (sqrt pi))
  (check-integral bell 0 +inf.0 (/ (sqrt pi) 2))
  (check-integral bell +inf.0 0 (/ (sqrt pi) -2))
  (check-integral exp -inf.0 1 (exp 1.0))
  (check-integral (lambda (x) (/ 1.0 (+ 1.0 (* x x)))) -inf.0 +inf.0 pi)
  (check-integral (lambda (x) (expt x -1.5)) 1 +inf.0 2.0)
  (check-integral (lambda (x) (* 1e18 (expt x -4))) 1e6 +inf.0 (/ 1.0 3))
  (check-equal? (integral exp +inf.0 +inf.0) 0.0))

(test-case "all of it close to one end of a long range"
  (check-integral (lambda (x) (exp (- x))) 0 1e6 1.0)
  (check-integral (lambda (x) (exp (- x 1e6))) 0 1e6 1.0))

(test-case "an end at infinity and another where it is infinite"
  (check-integral (lambda (x) (/ (exp (- x)) (sqrt x))) 0 +inf.0 (sqrt pi))
  (check-integral (lambda (x) (/ (exp (- 3.0 x)) (sqrt (- x 3.0)))) 3 +inf.0 (sqrt pi))
  (check-integral (lambda (x) (/ (log x) (+ 1.0 (* x x)))) 0 +inf.0 0.0))

(test-case "what happens close to an end is not extrapolated away"
  (for ([place (in-list '(1e-2 1e-4 1e-5))])
    (check-integral (lambda (x) (sqrt (abs (- x place)))) 0 1
                    (* 2/3 (+ (expt place 1.5) (expt (- 1.0 place) 1.5)))))
  (check-integral (lambda (x) (* 1e4 (exp (* -1e4 x)))) 0 1 1.0))

(test-case "units are of no account: an integral and its bound are scaled with the function"
  (define (f x) (+ 2.0 (sin (* 40.0 x))))
  (define-values (value bound) (improper-quadrature f 0 10))
  (for ([k (in-list '(-200 -40 40 200))])
    (define unit (expt 2.0 k))
    (define-values (value* bound*) (improper-quadrature (lambda (x) (* unit (f x))) 0 10))
    (check-equal? (list value* bound*) (list (* unit value) (* unit bound)))))

;; Only where it is real: the other side of the end tells nothing.
(test-case "a root that is infinite shortly beyond an end is not extrapolated, from either side"
  (for ([c (in-list '(1e-6 1e-9 1e-12))])
    (define (inverse-root u) (if (< u 0.0) +nan.0 (/ 1.0 (sqrt (+ u c)))))
    (define expected (* 2 (- (sqrt (+ 0.5 c)) (sqrt c))))
    (check-= (integral (lambda (x) (inverse-root (- x 1.0))) 1 1.5) expected 1e-9)
    (check-= (integral (lambda (x) (inverse-root (- 1.0 x))) 0.5 1) expected 1e-9)))

(test-case "integrals that do not exist are no numbers"
  (for ([example (in-list
                  (list (list (lambda (x) (/ 1.0 x)) 0 1)
                        (list (lambda (x) (/ 1.0 (* x x))) 0 1)
                        (list (lambda (x) (/ 1.0 x)) 1 +inf.0)
                        (list (lambda (x) (/ x (+ 1.0 (* x x)))) -inf.0 +inf.0)
                        (list sin 0 +inf.0)
                        (list (lambda (x) 1.0) 0 +inf.0)))])
    (check-exn exn:fail:mechanics:not-convergent? (lambda () (apply integral example)))))

(test-case "a slow tail beneath a fast one is not extrapolated away"
  (define ((tail c) x) (+ (expt x -1.5) (* c (expt x -0.5))))
  (for ([c (in-list '(1e-4 1e-8 1e-12))])
    (check-exn exn:fail:mechanics:not-convergent? (lambda () (integral (tail c) 1 +inf.0)))
    (check-exn exn:fail:mechanics:not-convergent?
               (lambda () (integral (lambda (x) ((tail c) (- x))) -inf.0 -1))))
  (check-integral (tail 0.0) 1 +inf.0 2.0))

;; ∫ cos(ax)/(1 + x²) = π/2 e^(−a); the first zero is at 40 units, and each next at 80 more.
(test-case "waves that begin slowly"
  (define a (/ pi 80.0))
  (define-values (value bound)
    (oscillating-quadrature (lambda (x) (/ (cos (* a x)) (+ 1.0 (* x x)))) 1.0 1e-10))
  (check-= value (* 0.5 pi (exp (- a))) 1e-10))

;; Its first minima are in the middle between numbers k/16, at which it is looked at.
(test-case "the period of a wave is found where its least values are equal, too"
  (define (f x)
    (define u (- x 17/32 (floor (- x 1/32))))
    (/ (+ 1.0 (* 1/2 u u) (* -1.0 u u u u)) (expt (max 1.0 (/ x 8.0)) 2)))
  (define-values (whole bound) (periodic-quadrature f 1.0 1e-7))
  (define-values (rest rest-bound) (periodic-quadrature (lambda (x) (f (+ x 1/64))) 1.0 1e-7))
  (check-= (- whole rest) (integral f 0 1/64) (+ bound rest-bound)))

;; The parts met tell +, the rule −: to extrapolate would be wrong by 2e-3.
(test-case "what is left near an end must have the sign that the rule tells"
  (define (f x) (/ (if (< x (- 3.0 3e-7)) 1.0 -1.0) (sqrt (- 3.0 x))))
  (check-exn #rx"^quadrature: the function is not finite" (lambda () (integral f 2 3)))
  (check-exn #rx"^quadrature: the function is not finite"
             (lambda () (integral (lambda (x) (- (f x))) 2 3))))

(test-case "bounds of errors add up where integrals do"
  (define (bound f low high)
    (define-values (value bound) (improper-quadrature f low high #:tolerance 1e-6))
    bound)
  (define (f x) (/ (exp (* -1/2 (abs x))) (+ 1.0 (abs (- x 0.3)))))
  (define-values (left right) (values (bound f -inf.0 0.0) (bound f 0.0 +inf.0)))
  (check-true (< 0.0 (* 10 left) (* 100 right)))
  (check-equal? (bound f -inf.0 +inf.0) (+ left right))
  (check-equal? (bound f +inf.0 -inf.0) (+ left right)))

(test-case "a failure says where, in the variable of the integrand"
  (define failure
    (with-handlers ([exn:fail:mechanics:not-convergent? exn-message])
      (integral (lambda (x) (/ 1.0 x)) 1 +inf.0)))
  (check-regexp-match
   #rx"^quadrature: the integral does not converge\n  trouble near: [0-9.]*e[+][0-9]+"
   failure))

(test-case "wrong arguments are refused by name"
  (check-exn #rx"quadrature: expected a real number, perhaps infinite"
             (lambda () (integral exp +nan.0 1)))
  (check-exn #rx"quadrature: expected a real number, perhaps infinite"
             (lambda () (integral exp 0 'a)))
  (check-exn #rx"positive tolerance"
             (lambda () (improper-quadrature exp 0 1 #:tolerance 0))))

(test-case "a mistake of the integrand's that only the search for its zeros meets is told"
  (define (f x) (if (< (abs (- x pi)) 1e-3) (error "a mistake") (/ (sin x) x)))
  (check-exn #rx"^a mistake$" (lambda () (oscillating-quadrature f 1.0 1e-10))))
