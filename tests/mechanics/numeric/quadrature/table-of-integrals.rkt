#lang racket/base
;; Integrals with known values, each to several tolerances: the error is not greater
;; than what was asked, and not greater than the bound that comes with the value.

(require mechanics/error/failure
         mechanics/numeric/quadrature/improper
         tests/mechanics/support/integrals
         tests/mechanics/support/hard-integrals
         tests/mechanics/support/hostile-integrals
         "../../support/checks.rkt")

(define (integrate example [tolerance 1e-10] [low entry-low] [high entry-high])
  (improper-quadrature (entry-f example) (low example) (high example) #:tolerance tolerance))

(define (judge example tolerance)
  (define value (entry-value example))
  (define size (entry-size example))
  (with-check-info (['integral (entry-name example)])
    (define-values (found bound) (integrate example tolerance))
    (define off (abs (- (inexact->exact found) (inexact->exact value))))
    ;; the values here are themselves rounded
    (define rounding (* 4e-15 (+ size (abs value))))
    (check-true (<= off (+ (* tolerance size) rounding)) (format "off by ~a" off))
    (check-true (<= off (+ bound rounding)) (format "~a ± ~a, but off by ~a" found bound off))))

(test-case "the table is long"
  (check-true (>= (length classic-integrals) 50))
  (check-true (>= (+ (length classic-integrals) (length hard-integrals) (length hostile-integrals))
                  270)))

(for ([tolerance (in-list '(1e-4 1e-8 1e-12))])
  (for ([example (in-list classic-integrals)])
    (test-case (format "~a to ~a" (entry-name example) tolerance) (judge example tolerance))))

(for* ([tolerance (in-list '(1e-6 1e-10))]
       [example (in-list (append hard-integrals hostile-integrals))])
  (test-case (format "~a to ~a" (entry-name example) tolerance) (judge example tolerance)))

;; π is no flonum: near it rounding hides the last digits of the distance.
(test-case "infinite at several points inside, where these are not exactly numbers"
  (define example
    (entry "|sin x|^(−1/2)" (lambda (x) (/ 1 (sqrt (abs (sin x))))) 1/2 7 10.776180652782937 10.8))
  (for ([tolerance '(1e-4 1e-8)]) (judge example tolerance))
  (check-exn exn:fail:mechanics:not-convergent? (lambda () (judge example 1e-12))))

(test-case "reversed ends change the sign"
  (for ([example (in-list classic-integrals)])
    (define-values (value bound) (integrate example))
    (define-values (back bound*) (integrate example 1e-10 entry-high entry-low))
    (check-equal? back (- value))
    (check-equal? bound* bound)))

(test-case "what has no integral is refused, with the place"
  (for ([example
         (list (list (lambda (x) (/ 1.0 x)) 0 1 0)
               (list (lambda (x) (/ 1.0 x)) -1 2 0)
               (list (lambda (x) (/ 1.0 (* x x))) 0 1 0)
               (list (lambda (x) (/ 1.0 (* x (log x)))) 0 1/2 0)
               (list (lambda (x) (/ 1.0 (- (* x x) 2.0))) 1 3 (sqrt 2.0)))])
    (define-values (f low high place) (apply values example))
    (define failure
      (with-handlers ([exn:fail:mechanics:not-convergent:integral? values])
        (improper-quadrature f low high)))
    (check-pred exn:fail:mechanics:not-convergent:integral? failure)
    (check-= (exn:fail:mechanics:not-convergent:integral-where failure) place 1e-10)
    (check-pred flonum? (exn:fail:mechanics:not-convergent-value failure))
    (check-pred flonum? (exn:fail:mechanics:not-convergent-error-estimate failure))))

;; Epsilon algorithms find limits of sums that have none; that of sin x to infinity is 1.
(test-case "what goes up and down without decaying has no integral"
  (for ([f (list sin cos
                 (lambda (x) (* x (sin x)))
                 (lambda (x) (* (sin x) (+ 0.01 (/ 1 (+ 1 x)))))
                 (lambda (x) (/ (+ 1 (sin x)) (+ 1 x)))
                 (lambda (x) (/ (sin (log (+ 1 x))) (+ 1 x)))
                 (lambda (x) (/ (sin (* 1/5 (log (+ 1 x)))) (+ 1 x))))])
    (check-exn exn:fail:mechanics:not-convergent? (lambda () (improper-quadrature f 0 +inf.0))))
  (for ([f (list (lambda (x) (/ (sin (log x)) x))
                 (lambda (x) (/ (cos (/ 1 x)) x x)))])
    (check-exn exn:fail:mechanics:not-convergent? (lambda () (improper-quadrature f 0 1)))))

(define (refusal f low high)
  (with-handlers ([exn:fail:mechanics:not-convergent? exn-message])
    (improper-quadrature f low high)))

(test-case "an integral is said not to converge only where it is seen not to"
  (for ([example
         (list (list (lambda (x) (/ 1.0 x)) 0 1)
               (list (lambda (x) (/ 1.0 x)) 1 +inf.0)
               (list (lambda (x) (/ 1e-9 x)) 1 +inf.0)
               (list (lambda (x) (expt x -1.5)) 0 1)
               (list (lambda (x) (/ 1.0 (- (* x x) 2.0))) 1 3)
               (list (lambda (x) (/ 1.0 (* x (log x)))) 0 1/2)
               (list (lambda (x) (/ 1.0 (* x (log (- x))))) -1/2 0)
               (list (lambda (x) (/ x (+ 1.0 (* x x)))) 0 +inf.0)
               (list (lambda (x) 1.0) -inf.0 0)
               (list sin 0 +inf.0))])
    (check-regexp-match #rx"^quadrature: the integral does not converge\n"
                        (apply refusal example))))

;; Near x, numbers are too far apart for the peak; near 0 they are not.
(test-case "what rounding of x spoils is refused, and says so"
  (define (Lorentz c) (lambda (x) (/ 1e-8 (+ 1e-16 (square (- x c))))))
  (check-regexp-match #rx"^quadrature: the integral was not found to the tolerance asked, for .*\n"
                      (refusal (Lorentz 0.2) 0 1))
  (define-values (found bound) (improper-quadrature (Lorentz 0.0) -1 1))
  (check-= found 3.1415926335897932385 (+ bound 1e-15)))

(test-case "waves that go on for too long are not done, and said to be unknown"
  (for ([f (list (lambda (x) (/ (abs (sin x)) (* x x)))
                 (lambda (x) (/ (* (sin x) (sin (* (sqrt 2) x))) x x)))])
    (check-regexp-match #rx"^quadrature: the integral was not found .* is not known\n"
                        (refusal f 1 +inf.0))))

(test-case "singular parts of every kind that have no integral are refused"
  (for ([example
         (list (list (lambda (x) (tan x)) 0 3)
               (list (lambda (x) (/ 1.0 (square (- x 0.3)))) 0 1)
               (list (lambda (x) (/ 1.0 (sin x))) 1 5)
               (list (lambda (x) (expt x -1.01)) 0 1)
               (list (lambda (x) (expt x -0.99)) 1 +inf.0)
               (list (lambda (x) (+ 1e-12 (exp (- x)))) 0 +inf.0)
               (list (lambda (x) (+ (expt x -1.5) (* 1e-12 (expt x -0.5)))) 1 +inf.0)
               (list (lambda (x) (square (sin x))) 0 +inf.0)
               (list (lambda (x) (/ 1.0 (+ x (sin x)))) 1 +inf.0)
               (list (lambda (x) (/ x (+ 1.0 (* x x)))) -inf.0 +inf.0)
               (list (lambda (x) (/ (cos x) x)) 0 +inf.0))])
    (check-regexp-match #rx"^quadrature: the integral does not converge\n"
                        (apply refusal example)))
  (for ([example
         (list (list (lambda (x) (/ 1.0 (- x 1/3))) 0 1)
               (list (lambda (x) (/ 1.0 (- 1 (* x x)))) 0 1)
               (list (lambda (x) (/ 1.0 (- (exp x) 2))) 0 1)
               (list (lambda (x) (expt (abs (- x 0.5)) -1.2)) 0 1)
               (list exp 0 +inf.0))])
    (check-exn exn:fail:mechanics? (lambda () (apply improper-quadrature example)))))

(test-case "a plain function costs some 240 evaluations, one whose panels are narrow less on top"
  (define (evaluations f low high)
    (define count 0)
    (improper-quadrature (lambda (x) (set! count (+ count 1)) (f x)) low high)
    count)
  (check-true (<= (evaluations sin 0 pi) 240))
  (check-true (<= (evaluations (lambda (x) (cos (* 1000 x))) 0 10) (+ 42945 240))))

;; They converge, by a log log or beyond the range of flonums.
(test-case "what is not found, and not seen to diverge, is said to be unknown"
  (for ([example
         (list (list (lambda (x) (/ 1.0 x (log x) (square (log (log x))))) 10 +inf.0)
               (list (lambda (x) (expt x -1.00001)) 1 +inf.0)
               (list (lambda (x) (expt x -0.99999)) 0 1))])
    (check-regexp-match #rx"^quadrature: the integral was not found to the tolerance asked; whether"
                        (apply refusal example))))

(test-case "or the point where it is infinite is told"
  (for ([example (list (list (lambda (x) (expt (- 2.0 x) -1.5)) 0 2 2)
                       (list (lambda (x) (/ 1.0 x)) -1 1 0))])
    (define-values (f low high place) (apply values example))
    (define failure
      (with-handlers ([exn:fail:mechanics:singular? values])
        (improper-quadrature f low high)))
    (check-pred exn:fail:mechanics:singular? failure)
    (check-= (exn:fail:mechanics:singular-where failure) place 0.0)))
