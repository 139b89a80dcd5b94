#lang mechanics
;; A pendulum, let go at an angle that a slider gives. Small swings take the time of a harmonic
;; oscillator, drawn grey; wide ones take longer, and friction makes wide ones small.

(require mechanics/plot)
(provide interaction)

(define (rates friction)
  (lambda ((up t angle rate)) (up 1 rate (- (* -9.8 (sin angle)) (* friction rate)))))

(define (swing angle friction)
  (evolve-trajectory (rates friction) (up 0. angle 0.) 10.))

(define interaction
  (interact ([angle 0.1 3.1 #:start 1.0] [friction 0.0 1.0])
    (define f (frame 0 10 -3.2 3.2 #:x-label "t" #:y-label "angle" #:width 500 #:height 300))
    (plot-function f (lambda (t) (* angle (cos (* (sqrt 9.8) t)))) 0 10 #:color 'gray)
    (plot-trajectory f (swing angle friction) coordinate #:color 'blue)
    f))
interaction

(module+ test
  (require rackunit)
  (define (crossing angle)
    (define falling
      (evolve-trajectory (rates 0) (up 0. angle 0.) 10. #:events (event coordinate #:terminal? #t)))
    (trajectory-end falling))
  (test-case "a small swing takes as long as a harmonic oscillator's, a wide one longer"
    (check-= (crossing 0.01) (/ :pi 2 (sqrt 9.8)) 1e-5)
    (check-true (> (crossing 3.) (* 2 (crossing 0.1))))))
