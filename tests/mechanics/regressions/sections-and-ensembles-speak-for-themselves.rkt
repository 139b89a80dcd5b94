#lang racket/base
;; An event without a real value was reported by "evolve-trajectory", which nobody had called, and
;; the first start of an ensemble that is no number without its index.

(require mechanics "../support/checks.rkt")

(define (oscillator s) (up 1 (momentum s) (- (coordinate s))))
(define undefined (event (lambda (s) (sqrt (- (coordinate s) 0.5)))))

(test-case "of a section"
  (check-exn #rx"^Poincare-map: the function of an event has no real value"
             (lambda () ((Poincare-map oscillator undefined) (up 0 1.0 0)))))

(test-case "of an ensemble, a failure of the start"
  (define all (evolve-ensemble oscillator (list (up 0 1.0 0)) 3 #:events undefined #:jobs 1))
  (check-regexp-match #rx"^evolve-ensemble: the function of an event has no real value"
                      (ensemble-failure-message (car all))))

(test-case "the index of a start that is no number"
  (for ([k '(0 1 2)] [x '(+nan.0 +inf.0 -inf.0)])
    (define starts (for/list ([i 3]) (up 0 (if (= i k) x 1.0) 0)))
    (check-exn (regexp (format "^evolve-ensemble: start ~a is not made of finite real numbers" k))
               (lambda () (evolve-ensemble oscillator starts 3 #:jobs 1)))))
