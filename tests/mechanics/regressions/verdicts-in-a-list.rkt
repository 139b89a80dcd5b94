#lang racket/base
;; In a list of verdicts each begins a line; they once followed each other on one, with the
;; lines beneath them out of place.

(require mechanics mechanics/show/display/result "../support/checks.rkt")

(define (shown x) (format "~v" (simplified-result x 60)))
(define rests-on-a-sign (assuming ('(> a 0)) (prove-zero (- (sqrt (square 'a)) 'a))))

(test-case "one below the other, with what belongs to them"
  (check-equal? (shown (list rests-on-a-sign (prove-zero 'b) 1/2 "text" (+ 'x 'x)))
                (string-append "(list proved: the residual is zero\n"
                               "        given: (> a 0)\n"
                               "      refuted: the residual is not zero\n"
                               "        residual: b\n"
                               "        at: b = 1\n"
                               "        value: 1\n"
                               "      1/2\n"
                               "      \"text\"\n"
                               "      (* 2 x))")))

(test-case "lists within lists"
  (check-equal? (shown (list (list (prove-zero 0) 1) (prove-zero 0)))
                (string-append "(list (list proved: the residual is zero\n"
                               "            1)\n"
                               "      proved: the residual is zero)")))

(test-case "beside what is more than text, Racket prints the list"
  (define b (box 1))
  (check-eq? (cadr (simplified-result (list (prove-zero 0) b) 60)) b))

(test-case "answers in words, each on a line"
  (define (L (up t x v)) (- (* 1/2 'm (square v)) (* 1/2 'k (square x))))
  (check-equal? (shown (list (equilibrium-stability L 0) 'x))
                (string-append "(list stable if (> k 0), unstable if that is reversed\n"
                               "      x)")))

(test-case "a list stays in one line if it fits, and is broken between its elements if not"
  (define (L (up t x v)) (- (* 1/2 'm (square v)) (* 1/4 (square (- (square x) (square 'a))))))
  (define places (equilibria L (up 't 'x 'v)))
  (check-equal? (shown (list (car places) (up 'a 'b))) "(list (equilibrium 0) (up a b))")
  (define lines (regexp-split #rx"\n" (shown (append places places))))
  (check-equal? (length lines) (* 2 (length places)))
  (check-equal? (shown (list (up 'a (* 'long-name 'another-name)) (up 'a (* 'long-name 'b))))
                "(list (up a (* another-name long-name))\n      (up a (* b long-name)))"))
