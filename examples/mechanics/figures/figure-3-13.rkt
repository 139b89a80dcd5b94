#lang mechanics
;; A section of the driven pendulum with a doubled period  (SICM 3.6.1, Figure 3.13)
;;
;; A = 0.1 m, ω = 2 ω₀: the pendulum that hangs has become unstable; around it are two islands,
;; which an orbit visits in turn.

(require mechanics/plot "strobe.rkt")

(define T (strobe-map 0.1 2.))
(define win
  (strobe-section 0.1 2. 10. '((1. 0.) (3. 0.) (0.2 1.) (0. 2.) (0. 2.5) (0. 3.) (0. 3.5)) 400))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-3-13.png"))

(module+ test
  (require rackunit)
  (define hanging (find-fixed-point T (up 0. 0.)))
  (define doubled
    (filter (lambda (p) (eq? (fixed-point-kind p) 'elliptic))
            (periodic-points T 2 (list -0.8 0.8 -4. 4.) #:grid '(5 7))))
  (test-case "after one period"
    (define once (T 1. 0. list void))
    (check-= (car once) -1.035081853906921 1e-9)
    (check-= (cadr once) -1.391954888314461 1e-9))
  (test-case "hanging it is unstable, with multipliers that change sides"
    (check-equal? (fixed-point-kind hanging) 'reflection-hyperbolic)
    (check-= (apply + (fixed-point-multipliers hanging)) -2.09858252542 1e-7))
  (test-case "two stable points of period 2, each the image of the other"
    (check-equal? (length doubled) 2)
    (define-values (p q) (apply values (map fixed-point-coordinates doubled)))
    (define image (T (ref p 0) (ref p 1) up void))
    (check-= (ref image 0) (ref q 0) 1e-8)
    (check-= (ref image 1) (ref q 1) 1e-8)))
