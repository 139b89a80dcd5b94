#lang racket/base
;; How many times a monitor is called, and what is said of a long run between them.

(provide sample-count progress-text)

;; How many steps it takes to cover the span; a last one that is tiny is rounding.
(define (sample-count span step)
  (inexact->exact (ceiling (- (/ span step) 1e-6))))

;; "evolve: t = 37.2 of 100.0", to a thousandth of the end.
(define (progress-text who t end)
  (define digits (max 1 (- 4 (order (abs end)))))
  (format "~a: t = ~a of ~a" who
          (real->decimal-string t digits) (real->decimal-string end digits)))

;; How many digits x has before its point.
(define (order x)
  (let loop ([n 0] [x x]) (if (< x 1) n (loop (+ n 1) (/ x 10)))))
