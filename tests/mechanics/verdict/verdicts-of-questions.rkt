#lang mechanics
;; Verdicts as those who ask of systems see them: domains, kinks, what is assumed, asked again.

(require (except-in "../support/checks.rkt" check)
         (only-in mechanics/geometry define-coordinates R2-polar)
         (only-in mechanics/verdict/verdict verdict-claim claim-domain))

(define line (up 't 'x 'v))
(define ((in-potential V) (up t x v)) (- (* 1/2 (square v)) (V x)))

(test-case "where a Lagrangian that compares numbers is a root of what is negative, nothing rests"
  (define (L (up t x v)) (if (> x 1) (sqrt (- -1 (square t))) (square v)))
  (define (reason x) (verdict-reason (verify-equilibrium L x)))
  (check-equal? (map reason '(0 2)) '(#f nowhere-defined)))

(test-case "asked again under a condition, a question keeps its domain"
  (define ((L sign) (up t x v)) (+ (* 'k x) (sqrt (* sign (+ 1 (square t))))))
  (define (reason sign)
    (verdict-reason (verify-again (verify-equilibrium (L sign) 'x) '(= k 0))))
  (check-equal? (map reason '(1 -1)) '(#f nowhere-defined)))

(test-case "the domain of a question is kept for certificates of it"
  (define v (prove-zero 0 #:domain (lambda () (list (sqrt 'a)))))
  (check-equal? (claim-domain (verdict-claim v)) (list (sqrt 'a))))

(test-case "a potential that is differentiable twice has no kink"
  (define (kinks n)
    (define L (in-potential (lambda (x) (expt (abs x) n))))
    (length (verdict-kinks (verify-conserved L (Lagrangian->energy L) line))))
  (check-equal? (map kinks '(1 3)) '(1 0)))

(test-case "a radius is positive in a tuple, whatever stands beside it"
  (define-coordinates (up r phi) R2-polar)
  (define v (verify-equal (up (sqrt (square r)) (sqrt (square 'a))) (up r 'a)))
  (check-equal? (verdict-assumptions v) '((> r 0) (>= a 0))))

(test-case "what is neither negative nor 0 is positive"
  (define (L (up t x v)) (square v))
  (define v (verify-equivalent-Lagrangians L (* (sqrt (square 'c)) L) line))
  (check-equal? (verdict-assumptions v) '((> c 0))))

(test-case "powers too large to be expanded are a reason of their own"
  (define (f x) (expt (+ 'a 'b 'c 'd 'e x) 60))
  (define (g x) (expt (expand (square (+ 'a 'b 'c 'd 'e x))) 30))
  (check-eq? (verdict-reason (verify-equal (f 'f) (g 'f))) 'too-large))

(test-case "typeset, a report has the commas of the plain one between its equations"
  (define v (prove-zero (lambda (t) (+ (* (- 'a 'b) (sin t)) (* (- 'c 'd) (cos t))))))
  (define (commas rx text) (length (regexp-match* rx text)))
  (check-regexp-match #rx"zero if:[^:]* a=b\\\\text{,}[^:]* c=d[^:]*at:" (->TeX v))
  (check-equal? (commas #rx"{,}" (->TeX v)) (commas #rx"," (format "~a" v))))
