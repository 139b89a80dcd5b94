#lang racket/base
;; Zeros near the start, by a trust region.

(require racket/flonum
         mechanics/error/failure
         mechanics/numeric/optimization/trust-region
         "../../support/checks.rkt" "../../support/close.rkt" "../../support/messages.rkt")

(define (found f slopes start #:deficient? [deficient? #f])
  (define-values (x error) (trust-region f slopes start #:deficient? deficient?))
  (for/list ([u (in-flvector x)]) u))

(define (x-of v) (flvector-ref v 0))
(define (y-of v) (flvector-ref v 1))

;; Powell's function, whose derivatives at the zero have an inverse, and along the way hardly
(test-case "a badly scaled function"
  (define (f v)
    (flvector (- (* 1e4 (x-of v) (y-of v)) 1.0)
              (+ (exp (- (x-of v))) (exp (- (y-of v))) -1.0001)))
  (define (slopes v)
    (vector (vector (* 1e4 (y-of v)) (* 1e4 (x-of v)))
            (vector (- (exp (- (x-of v)))) (- (exp (- (y-of v)))))))
  (check-close (found f slopes (flvector 0.0 1.0)) '(1.098159327e-5 9.106146740) 1e-7))

(define (circle v) (flvector (+ (* (x-of v) (x-of v)) (* (y-of v) (y-of v)) -1.0) 0.0))
(define (circle-slopes v)
  (vector (vector (* 2.0 (x-of v)) (* 2.0 (y-of v))) (vector 0.0 0.0)))

(test-case "of a curve of zeros a near one is found"
  (define p (found circle circle-slopes (flvector 1.5 1.5) #:deficient? #t))
  (check-close p (list (sqrt 0.5) (sqrt 0.5)) 1e-10))

(test-case "where the values are least and not zero, there is none"
  (define (f v) (flvector (+ 1.0 (* (x-of v) (x-of v))) 0.0))
  (define (slopes v) (vector (vector (* 2.0 (x-of v)) 0.0) (vector 0.0 0.0)))
  (check-regexp-match #rx"^find-root: no root found"
                      (message-of (found f slopes (flvector 0.3 0.0) #:deficient? #t)
                                  exn:fail:mechanics?)))

;; f and 1, where f is 0
(define (check-least f slope end)
  (define failure
    (with-handlers ([exn:fail:mechanics:not-convergent? values])
      (found (lambda (v) (flvector (f (x-of v)) 1.0))
             (lambda (v) (vector (vector (slope (x-of v)) 0.0) (vector 0.0 0.0)))
             (flvector 0.3 0.0) #:deficient? #t)))
  (check-regexp-match (string-append "^find-root: no root found: " end "\n") (exn-message failure))
  (check-close (exn:fail:mechanics:not-convergent-value failure) '(0.0 0.0) 1e-7)
  (check-close (exn:fail:mechanics:not-convergent-error-estimate failure) 0 1e-7))

(test-case "a function that is 0 beside one that is not, to the last digit or but for rounding"
  (check-least values (lambda (x) 1.0) "the values are least here, and not 0")
  (check-least sin cos "no step leads closer to a root"))
