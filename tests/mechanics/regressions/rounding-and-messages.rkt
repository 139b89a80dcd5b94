#lang racket/base
;; Racket's own rounding met dual numbers and complained of the number in them;
;; comparisons showed 'a and #<procedure:cos>; powers of operators were not merged.

(require mechanics/generic/arithmetic mechanics/generic/elementary mechanics/generic/compare
         mechanics/generic/rounding
         mechanics/calculus/derivative mechanics/value/operator mechanics/value/structure
         mechanics/lagrangian/local-tuple
         "../support/checks.rkt")

(test-case "exact->inexact lets derivatives through"
  (check-equal? ((D g:exact->inexact) 3) 1)
  (check-equal? ((D (D (lambda (x) (g:* x (g:exact->inexact x))))) 3) 2)
  (check-equal? (g:exact->inexact (up 1/2 'x)) (up 0.5 'x)))

(test-case "roundings are constant but where they jump"
  (check-equal? ((D g:floor) 1.5) 0)
  (check-equal? ((D (lambda (t) (g:square (g:- t (g:floor t))))) 9/4) 1/2)
  (check-equal? ((D (D (lambda (t) (g:* t t (g:round t))))) 9/4) 4)
  (check-equal? (list ((D g:truncate) 0) ((D g:round) 2) ((D g:ceiling) 1/2)) '(0 0 0))
  (for ([f (list g:floor g:ceiling g:truncate)])
    (check-exn #rx"^[a-z]+: has no derivative where it jumps, at 2$" (lambda () ((D f) 2))))
  (check-exn #rx"^round: has no derivative" (lambda () ((D g:round) -5/2)))
  (check-exn #rx"^floor: cannot be taken of a number-like expression\n" (lambda () (g:floor 'x)))
  (check-equal? ((g:floor g:sqrt) 5) 2)
  (check-equal? ((g:floor g:sqrt) 5.0) 2.0)
  (check-equal? (list (g:magnitude 3+4i) (g:magnitude -2)) '(5 2)))

(test-case "comparisons name what they cannot compare"
  (check-exn #rx"\n  value: the procedure `cos`$" (lambda () (g:max g:cos 1)))
  (check-exn #rx"^zero[?]: expected a value of the arithmetic\n  value: \"a\", a string$"
             (lambda () (g:zero? "a")))
  (check-false (g:zero? g:cos)))

(test-case "names of the library's own procedures do not show"
  (check-exn #rx"^s:generate: " (lambda () (s:generate -1 'up values)))
  (check-exn #rx"^atan: the point at the origin has no angle" (lambda () (g:atan 0 0)))
  (check-equal? (g:atan 0 1) 0)
  (check-exn #rx"^velocity: .*\n  a list is not a tuple; use [(]up t q v ...[)]$"
             (lambda () (velocity '(0 1 2)))))

(test-case "powers of an operator are merged"
  (define (text o) (format "~a" o))
  (check-equal? (text (g:cube D)) "(expt D 3)")
  (check-equal? (text (g:* (g:expt D 2) D)) "(expt D 3)")
  (check-equal? (text (g:expt (g:square D) 3)) "(expt D 6)")
  (check-equal? (((g:cube D) (lambda (x) (g:expt x 3))) 'x) 6)
  (check-equal? (((g:* D I-operator) g:sin) 0) 1))
