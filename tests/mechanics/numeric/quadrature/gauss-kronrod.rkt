#lang racket/base
;; Quadrature against integrals known in closed form.

(require mechanics/error/failure
         mechanics/numeric/quadrature/gauss-kronrod
         "../../support/checks.rkt")

(define pi 3.141592653589793)

(define (check-integral expected f low high relative)
  (check-= (quadrature f low high) expected (* relative (max 1.0 (abs expected)))))

;; The integral of x^n over [0, 1] by one panel.
(define (one-panel-monomial n)
  (define-values (value bound)
    (quadrature/error (lambda (x) (expt x n)) 0 1 #:limit 1 #:tolerance 1e9))
  value)

(test-case "constants are integrated without any error"
  (check-equal? (quadrature (lambda (t) 87/2) 0 10) 435.0)
  (check-equal? (quadrature (lambda (t) 1/3) -2 1) 1.0))

(test-case "one panel is exact, within rounding, to degree 31"
  (for ([n (in-range 32)])
    (check-= (one-panel-monomial n) (/ 1.0 (+ n 1)) 1e-16 (format "x^~a" n))))

(test-case "one panel is not exact at degree 64: the check above can fail"
  (check-true (> (abs (- (one-panel-monomial 64) 1/65)) 1e-15)))

(test-case "the action of the varied free path is 435 + 18077/14000"
  ;; SICM p. 18; the closed form is exact.
  (define ((varied epsilon) t)
    (define nu (* t (- t 10)))
    (define Dnu (- (* 2 t) 10))
    (define (component v f Df) (+ v (* epsilon (+ (* Dnu f) (* nu Df)))))
    (define vx (component 4 (sin t) (cos t)))
    (define vy (component 3 (cos t) (- (sin t))))
    (define vz (component 2 (* t t) (* 2 t)))
    (* 3/2 (+ (* vx vx) (* vy vy) (* vz vz))))
  (check-equal? (quadrature (varied 0) 0 10) 435.0)
  (check-= (quadrature (varied 0.001) 0 10) (+ 435 18077/14000) 2e-13))

(test-case "elementary functions"
  (check-integral 2.0 sin 0 pi 1e-15)
  (check-integral (- (exp 1.0) 1.0) exp 0 1 1e-15)
  (check-integral (/ pi 4) (lambda (x) (/ 1 (+ 1 (* x x)))) 0 1 1e-15)
  (check-integral (sqrt pi) (lambda (x) (exp (- (* x x)))) -10 10 1e-12))

(test-case "an integral that is zero by symmetry converges"
  (check-= (quadrature sin 0 (* 2 pi)) 0.0 1e-14))

(test-case "reversed limits change the sign and equal ones give zero"
  (check-equal? (quadrature exp 1 0) (- (quadrature exp 0 1)))
  (check-equal? (quadrature exp 2 2) 0.0))

(test-case "an integrable singularity at an end and a jump are refined"
  (check-integral 2.0 (lambda (x) (/ 1 (sqrt x))) 0 1 1e-9)
  (check-integral (log 2.0) (lambda (x) (if (< x 1/3) 0 (/ 1 (+ 1/3 x)))) 0 1 1e-9))

(test-case "the error is less than the bound that is given with the value"
  (for ([f (list sin sqrt (lambda (x) (abs (- x 0.3))) (lambda (x) (/ 1 (+ 1e-4 (* x x)))))]
        [exact (list (- 1.0 (cos 1.0)) 2/3 0.29 (* 100 (atan 100.0)))])
    (for ([tolerance '(1e-3 1e-6 1e-12)])
      (define-values (value bound) (quadrature/error f 0 1 #:tolerance tolerance))
      (check-true (<= (abs (- value exact)) bound)
                  (format "~a at ~a: ~a ± ~a" f tolerance value bound)))))

(test-case "an integral that halving does not find is a failure that carries the best value"
  (define failure
    (with-handlers ([exn:fail:mechanics:not-convergent? values])
      (quadrature (lambda (x) (/ 1 x)) 0 1 #:limit 40 #:name 'definite-integral)))
  (check-pred exn:fail:mechanics:not-convergent? failure)
  (check-regexp-match
   #rx"^definite-integral: the integral was not found to the tolerance asked; .*\n  trouble near: .*\n  best value: .*\n  error estimate: "
   (exn-message failure))
  (check-true (< 20 (exn:fail:mechanics:not-convergent-value failure) 40))
  (check-true (< 0.1 (exn:fail:mechanics:not-convergent-error-estimate failure))))

(test-case "where the function is infinite or no number is said"
  (define failure
    (with-handlers ([exn:fail:mechanics:singular? values])
      (quadrature (lambda (x) (/ 1.0 (- x 1.0))) 0 2)))
  (check-pred exn:fail:mechanics:singular? failure)
  (check-equal? (exn:fail:mechanics:singular-where failure) 1.0)
  (check-equal? (exn-message failure)
                "quadrature: the function is not finite\n  at: 1.0\n  given: +inf.0")
  (check-exn #rx"quadrature: the function is not finite\n  at: 1.0\n  given: [+]nan.0"
             (lambda () (quadrature (lambda (x) +nan.0) 0 2))))

(test-case "wrong arguments are refused by name"
  (check-exn
   #rx"^quadrature: the function must give real numbers; does it still contain symbols[?]\n  at: 1.0\n  given: 'm"
   (lambda () (quadrature (lambda (x) 'm) 0 2)))
  (check-exn
   #rx"definite-integral: expected a finite real number as limit of integration\n  given: 'b"
   (lambda () (quadrature sin 0 'b #:name 'definite-integral)))
  (check-exn #rx"a finite real number" (lambda () (quadrature sin 0 +inf.0)))
  (check-exn #rx"a positive tolerance" (lambda () (quadrature sin 0 1 #:tolerance 0))))
