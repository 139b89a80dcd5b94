#lang racket/base
;; D-numeric takes differences over shorter and shorter steps, each half as long.  All of the first
;; ones may be nearly whole periods of the function: sin 1000 x at 0 had the derivative -5.3, which
;; four of them agreed on, within 1e-8.

(require (except-in mechanics time) "../support/checks.rkt")

(for* ([w '(1000 700 440 710 7100 314 628.3 22 1e4 1e5)] [x '(0.0 0.0003 -0.0012 0.4)])
  (define d ((D-numeric (lambda (x) (sin (* w x)))) x))
  (check-= d (* w (cos (* w x))) (* 1e-6 w)))

(test-case "and so in other units"
  (for* ([k 13] [u '(-1.2 -0.3 0.1 0.7 1.4)])
    (define s (expt 10.0 (- k 6)))
    (check-= (* s ((D-numeric (lambda (x) (sin (/ x s)))) (* u s))) (cos u) 1e-6)))
