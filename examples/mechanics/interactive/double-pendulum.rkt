#lang mechanics
;; The way of a double pendulum's lower bob. It is let go at two angles. From little angles it
;; weaves a pattern; from great ones a change of a hundredth makes another way.

(require mechanics/plot)
(provide interaction)

;; Equal masses and rods; angles from the vertical.
(define ((L-double m l g) (up t (up a b) (up va vb)))
  (+ (* m (square l) (+ (square va) (* 1/2 (square vb)) (* va vb (cos (- a b)))))
     (* m g l (+ (* 2 (cos a)) (cos b)))))
(define L (L-double 1. 1. 9.8))

(define (motion a b)
  (evolve-trajectory (Lagrangian->state-derivative L) (up 0. (up a b) (up 0. 0.)) 8.))

(define ((lower-bob function sign) (up t (up a b) v)) (* sign (+ (function a) (function b))))

(define interaction
  (interact ([upper 0.0 3.0 #:step 0.01 #:start 0.5] [lower -3.0 3.0 #:step 0.01 #:start 1.0])
    (define f (frame -2.1 2.1 -2.1 2.1 #:x-label "x" #:y-label "y" #:aspect-ratio 'equal))
    (plot-trajectory f (motion upper lower) (lower-bob sin 1) (lower-bob cos -1))
    f))
interaction

(module+ test
  (require rackunit)
  (define energy (Lagrangian->energy L))
  (test-case "energy is conserved"
    (for ([a '(0.5 2.5)])
      (check-= (energy ((motion a 1.) 8.)) (energy ((motion a 1.) 0.)) 1e-6))))
