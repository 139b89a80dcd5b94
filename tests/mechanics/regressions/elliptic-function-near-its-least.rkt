#lang racket/base
;; dn was the root of a difference, 1 − k² sn²: with k near 1 and u of some size, where it is
;; nearly 0, half of its digits were lost.  It is what a pendulum's momentum is that turns over
;; the top slowly.  The values are mpmath's, in 40 digits.

(require (except-in mechanics time) "../support/checks.rkt")

(define (dn u k) (Jacobi-elliptic-functions u k (lambda (sn cn dn) dn)))

(for ([case '((9.559268818313239 0.9999999999175826 0.00014138079697973776)
              (-8.487134591053238 0.9999999978647968 0.00041479592544260787)
              (8.775624187041501 0.9999999931048724 0.00032006552656547902)
              (-9.898614911109187 0.9999999965296433 0.00011775589423557701))])
  (define-values (u k expected) (apply values case))
  (check-= (dn u k) expected (* 1e-11 expected)))

(test-case "and its derivative"
  ;; dn' = −k² sn cn
  (for ([u '(0.3 1.7 9.0)] [k '(0.5 0.99 0.99999999)])
    (define expected (Jacobi-elliptic-functions u k (lambda (sn cn dn) (- (* k k sn cn)))))
    (check-= ((D (lambda (u) (dn u k))) u) expected (* 1e-9 (abs expected)))))
