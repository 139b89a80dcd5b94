#lang racket/base
;; Orbits compared with a rotation by an exact fraction of a turn, which is back where it began
;; after a few steps, were followed for twenty million more: minutes for the map of a motion.

(require mechanics mechanics/book "../support/checks.rkt")

(define calls 0)
(define ((counted map) x y return fail)
  (set! calls (+ calls 1))
  (map x y return fail))

;; I ↦ I, θ ↦ θ + I: a rotation by I, ahead of another one if I is greater
(define (shear theta I return fail) (return (+ theta I) I))

(test-case "they are told apart when it is back"
  (for* ([q '(1/2 1/4 3/4 1/8)] [d '(-0.01 0.01)])
    (set! calls 0)
    (check-equal? (which-way? q 0 (+ (* :2pi q) d) (counted shear)) (if (> d 0) 1 -1))
    (check-true (< calls 1000) (format "~a calls" calls)))
  (check-equal? (which-way? 0.25 0 (/ pi 2) shear) 0))

(test-case "the periodic orbits of the standard map with reflection are found"
  (define J (find-invariant-curve (standard-map 0.3) 1/4 0 1.2 2.0 1e-9))
  (define-values (x y)
    ((iterated-map (standard-map 0.3) 4) 0 J values void))
  (check-= (sin x) 0 1e-6)
  (check-= y J 1e-6))

(test-case "a motion, in few periods"
  (define T (driven-pendulum-map 1 1 9.8 0.002 (* 4.2 (sqrt 9.8))))
  (set! calls 0)
  (check-true (< 16 (find-invariant-curve (counted T) 0.25 0 16 18 1e-5) 18))
  (check-true (< calls 1000) (format "~a calls" calls)))
