#lang racket/base
;; For which exponent is a transformation canonical?  (SICM, exercise 5.7)

(require mechanics "../support/checks.rkt")

(define line (up 't 'theta 'I))
(define ((powers factor exponent) (up t theta I))
  (define r (* factor (expt I exponent)))
  (up t (* r (sin theta)) (* r (cos theta))))

(define (remarks C) (verdict-remarks (verify-canonical C line)))

(test-case "an exponent, and with it a factor"
  (check-equal? (remarks (powers 'beta 'alpha))
                '("it is zero at all states if alpha = 1/2 and (expt beta 2) = 2"))
  (check-pred proved? (verify-canonical (powers (sqrt 2) 1/2) line))
  (check-equal? (verdict-remarks (verify-symplectic (powers 'beta 'alpha) line))
                (remarks (powers 'beta 'alpha))))

(test-case "a relation of two exponents"
  (define (stretched exponent)
    (lambda (s) (up (time s) (expt (coordinate s) 'a)
                    (/ (* (momentum s) (expt (coordinate s) exponent)) 'a))))
  (check-equal? (remarks (stretched 'b)) '("it is zero at all states if a = (- 1 b)"))
  (check-pred proved? (verify-canonical (stretched (- 1 'a)) line)))

(test-case "one that no exponent makes canonical, and one where the exponent is right"
  (check-equal? (remarks (powers 1 'alpha)) '())
  (define v (verify-canonical (powers 'beta 1/2) line))
  (check-equal? (verdict-conditions v) '((= (expt beta 2) 2)))
  (check-false (ormap (lambda (text) (regexp-match? #rx"all states" text)) (verdict-remarks v))))

(test-case "with two Hamiltonians, too"
  (define (H s) (momentum s))
  (define v (verify-canonical (lambda (s) (up (time s) (* 2 (coordinate s)) (* 1/2 (momentum s))))
                              H (lambda (s) (* 1/2 (expt (momentum s) 'n))) line))
  (check-equal? (verdict-remarks v) '("it is zero at all states if n = 1")))
