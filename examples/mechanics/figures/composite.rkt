#lang mechanics
;; A section put together of the perturbative solutions of three resonances, and the section of the
;; driven pendulum itself, for figures 7.10 and 7.11.  Each start is told by the theory of the
;; resonance that is nearest; the theories of ω, 0 and −ω are blue, black and red.

(require mechanics/plot "resonances.rkt")

(provide resonances composite true-section)

(define resonances '((0 1) (-1 1) (1 1)))

(define (nearest p)
  (argmin (lambda (k) (abs (- p (middle k)))) resonances))

(define (composite gamma starts n)
  (define picture (section-frame))
  (for ([k resonances] [color '(black blue red)])
    (define own (filter (lambda (start) (equal? (nearest (cadr start)) k)) starts))
    (draw-theory picture gamma k own n #:color color))
  picture)

(define (true-section gamma starts n)
  (define picture (section-frame))
  (draw-section picture gamma starts n)
  picture)
