#lang racket/base
;; Reports on a long run while it lasts.

(provide progress-text)

;; "evolve: t = 37.2 of 100.0", to a thousandth of the end.
(define (progress-text who t end)
  (define digits (max 1 (- 4 (order (abs end)))))
  (format "~a: t = ~a of ~a" who
          (real->decimal-string t digits) (real->decimal-string end digits)))

;; How many digits x has before its point.
(define (order x)
  (let loop ([n 0] [x x]) (if (< x 1) n (loop (+ n 1) (/ x 10)))))
