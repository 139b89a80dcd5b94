#lang racket/base
;; Derivatives from values.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/error/failure
         mechanics/value/structure
         mechanics/calculus/derivative
         mechanics/search/numeric-derivative
         "../support/checks.rkt")

;; ((name f points) ...)
(define smooth
  (list (list "sin" g:sin '(0 1 -2 100 1e6))
        (list "exp" g:exp '(-5 0 1 20))
        (list "log" g:log '(1e-6 0.5 3 1e8))
        (list "1/x" (lambda (x) (g:/ 1 x)) '(0.01 -3 1e5))
        (list "√x" g:sqrt '(1e-3 2 1e10))
        (list "x³ + 2x" (lambda (x) (g:+ (g:expt x 3) (g:* 2 x))) '(0 1 -7))
        (list "(x − 1)²" (lambda (x) (g:square (g:- x 1))) '(1 2))
        (list "a constant" (lambda (x) 3) '(0 5))
        (list "atan 50x" (lambda (x) (g:atan (g:* 50 x))) '(0 0.01 1))))

(test-case "to the tolerance, and within the error that is told, as D has it"
  (for* ([example (in-list smooth)] [tolerance '(1e-5 1e-8 1e-10)])
    (define-values (name f points) (apply values example))
    (for ([x (in-list points)])
      (define-values (value error count) ((D-numeric f #:tolerance tolerance #:report values) x))
      (define off (abs (- value ((D f) (exact->inexact x)))))
      (define text (format "~a at ~a to ~a: ~a ± ~a, off by ~a" name x tolerance value error off))
      (define size (max (abs value) (* 10 (abs (f (exact->inexact x))))))
      (check-true (<= off (+ (* tolerance size) 1e-15)) text)
      (check-true (<= off (+ error (* 4e-16 (abs value)) 1e-15)) text)
      (check-true (<= 5 count 81) text))))

(test-case "of functions with structured values"
  (define (helix t) (up (g:cos t) (g:sin t) (up (g:* 1e6 t) 3)))
  (define v ((D-numeric helix) 1))
  (check-= (ref v 0) (- (sin 1.0)) 1e-9)
  (check-= (ref v 1) (cos 1.0) 1e-9)
  (check-= (ref v 2 0) 1e6 1e-2)
  (check-= (ref v 2 1) 0 1e-9)
  (check-true (up? ((D-numeric helix #:report (lambda (value error count) error)) 1))))

;; Of a sine over nearly whole periods the search begins anew (differences.rkt).
(test-case "all evaluations are told"
  (define-syntax-rule (check-count expression)
    (let ([calls 0])
      (define ((counted f) x)
        (set! calls (+ calls 1))
        (f x))
      (define count ((expression counted) 1))
      (check-equal? count calls)))
  (define (only-count value error count) count)
  (check-count (lambda (counted) (D-numeric (counted g:sin) #:report only-count)))
  (check-count (lambda (counted)
                 (D-numeric (counted (lambda (x) (sin (* 200 (atan 1) x)))) #:report only-count)))
  (check-count (lambda (counted)
                 (richardson-derivative (counted g:sin) 1e-8 (* 2000 (acos -1.0))
                                        #:report only-count)))
  (check-count (lambda (counted)
                 (lambda (x)
                   (define step (counted (lambda (x) (if (< x 1) 0 1))))
                   (define failure
                     (with-handlers ([exn:fail:mechanics:not-convergent? exn-message])
                       ((D-numeric step) x)))
                   (string->number (cadr (regexp-match #rx"evaluations: ([0-9]+)" failure)))))))

(test-case "a step may be given"
  (define-values (value error count) ((richardson-derivative g:sin 1e-8 0.01 #:report values) 1))
  (check-= value (cos 1.0) error)
  (check-= error 0 1e-8)
  ;; f is called no farther away
  (define (near x) (if (<= 0.99 x 1.01) (sin x) (raise-argument-error 'near "a number near 1" x)))
  (check-= ((richardson-derivative near 1e-8 0.01) 1) (cos 1.0) 1e-8))

(test-case "what has no derivative has none"
  (for ([f (list g:abs (lambda (x) (g:* 1e-3 (g:abs x))) (lambda (x) (if (< x 0) x (* 2 x))))])
    (check-exn #rx"^D-numeric: the slopes of the function on both sides differ\n  at: 0.0"
               (lambda () ((D-numeric f) 0))))
  (define failure
    (with-handlers ([exn:fail:mechanics:not-convergent? values])
      ((D-numeric (lambda (x) (if (< x 1) 0 1))) 1)))
  (check-regexp-match #rx"^D-numeric: no derivative found\n  at: 1.0\n  evaluations: 81"
                      (exn-message failure))
  (check-exn #rx"^D-numeric: the function is not finite on both sides\n  at: 0.0"
             (lambda () ((D-numeric g:log) 0)))
  (check-exn #rx"^richardson-derivative: the function is not finite on both sides"
             (lambda () ((richardson-derivative g:sqrt 1e-8) -1))))

(test-case "mistakes"
  (check-exn #rx"^D-numeric: expected a function of one variable"
             (lambda () (D-numeric 3)))
  (check-exn #rx"^D-numeric: expected a real number\n  given: the symbol x"
             (lambda () ((D-numeric g:sin) 'x)))
  (check-exn #rx"^D-numeric: expected a real number\n  given: .*a"
             (lambda () ((D-numeric (lambda (x) (g:* 'a x))) 1)))
  (check-exn #rx"^richardson-derivative: expected a positive tolerance"
             (lambda () ((richardson-derivative g:sin 0) 1)))
  (check-exn #rx"^richardson-derivative: expected a positive step"
             (lambda () (richardson-derivative g:sin 1e-8 -1))))
