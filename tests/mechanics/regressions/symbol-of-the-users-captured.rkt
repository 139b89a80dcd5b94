#lang racket/base
;; A function is judged at a symbol that is not the user's own t; it once was t
;; itself, and wrong solutions that mention 't were proved.

(require mechanics "../support/checks.rkt")

(define (status x) (verdict-status (prove-zero x)))

(test-case "a symbol t of the user's is not the function's argument"
  (check-eq? (status (lambda (s) (- s 't))) 'refuted)
  (check-eq? (status (lambda (a b) (- a 't0))) 'refuted)
  (check-eq? (status (lambda (t) (lambda (s) (- t s)))) 'refuted)
  (check-eq? (status (lambda (t) (lambda (s) (- (* t s) (* s t))))) 'proved))

(test-case "a path that mentions 't is judged at another time"
  (define (L-free local) (* 1/2 'm (square (velocity local))))
  (define (path s) (- (/ (cube s) 3) (* 't s s)))
  (check-eq? (verdict-status (verify-solution L-free path)) 'refuted))

(test-case "the argument is called t where it can be"
  (check-equal? (expression (verdict-residual (prove-zero (lambda (s) (sin s))))) '(sin t))
  (check-equal? (expression (verdict-residual (prove-zero (up (lambda (s) (sin s)) 't))))
                '(up (sin t) t))
  (check-equal? (expression (verdict-residual (prove-zero (lambda (s) (+ s 't))))) '(+ t t1)))

(test-case "numbers that are none are not called zero"
  (check-eq? (status +inf.0) 'refuted)
  (check-eq? (status +nan.0) 'undecided)
  (check-regexp-match #rx"not a number" (format "~a" (prove-zero +nan.0))))

(test-case "a witness keeps to what was assumed"
  (define v (prove-zero (+ (sqrt (expt (- 'a 'b) 2)) (sqrt (expt (- 'b 'a) 2)))))
  (check-eq? (verdict-status v) 'refuted)
  (define (at x) (apply substitute x (apply append (map (lambda (p) (list (car p) (cdr p)))
                                                        (verdict-witness v)))))
  (check-equal? (at (verdict-residual v)) (verdict-value v)))
