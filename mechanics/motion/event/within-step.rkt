#lang racket/base
;; Times and states within a step; an interpolant takes fractions of the step.

(require racket/flonum
         "event.rkt" "../system/system.rkt")

(provide crossings-in-time row-within)

;; found : the crossings in a step, at fractions of it -> the same at times
(define (crossings-in-time found from to)
  (for/list ([c (in-list found)])
    (struct-copy crossing c [at (time-within from to (crossing-at c))])))

;; Reckoned from the nearer end, so that rounding does not lead beyond.
(define (time-within from to theta)
  (define length (fl- to from))
  (if (fl< theta 0.5)
      (fl+ from (fl* theta length))
      (fl- to (fl* (fl- 1.0 theta) length))))

;; inside : the interpolant from one time to the other -> the state of s at the time x, an
;; flvector, whose clock, if it has one, is exact
(define (row-within s inside from to x)
  (define y (make-flvector (system-size s)))
  (define length (fl- to from))
  (inside (if (fl= length 0.0) 0.0 (fl/ (fl- x from) length)) y)
  (when (system-clock? s) (flvector-set! y 0 x))
  y)
