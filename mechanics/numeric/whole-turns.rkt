#lang racket/base
;; Angles but for whole turns.

(require racket/flonum
         "constants.rkt")

(provide whole-turns-less)

;; From −π to π.
(define (whole-turns-less x) (fl- x (fl* :2pi (flround (fl/ x :2pi)))))
