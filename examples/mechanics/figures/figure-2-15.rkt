#lang mechanics
;; The same errors with quaternions for the orientation  (SICM 2.12.1, Figure 2.15)
;;
;; On the scale of a tenth of Figure 2.2.

(require mechanics/plot mechanics/book)

(define-values (A B C) (values 1.0 (sqrt 2.0) 2.0))
(define in-angles (up 0.0 (up 1.0 0.0 0.0) (up 0.1 0.1 0.1)))
(define state0
  (up 0.0
      (quaternion->vector (rotation-matrix->quaternion (Euler->M (coordinate in-angles))))
      (Euler-state->omega-body in-angles)))
(define (energy s) ((T-body A B C) (velocity s)))
(define L-in-space (qw-state->L-space A B C))
(define-values (E0 L0) (values (energy state0) (L-in-space state0)))

(define win (frame 0.0 100.0 -1e-13 1e-13 #:width 600 #:height 300 #:x-label "t"))
(define (monitor state)
  (define (show value reference)
    (plot-point win (time state) (relative-error value reference)))
  (for ([i 3]) (show (ref (L-in-space state) i) (ref L0 i)))
  (show (energy state) E0))

(define last-state ((evolve qw-sysder A B C) state0 monitor 0.1 100.0 1e-14))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-2-15.png"))

(module+ test
  (require rackunit)
  (define errors (map (lambda (p) (ref p 1)) (frame-points win)))
  (test-case "four errors at each tenth of a second, all below 1e-13"
    (check-equal? (length errors) 4004)
    (for ([e errors]) (check-true (< (abs e) 1e-13))))
  (test-case "the quaternion after 100 s, and its length"
    (check-= (ref last-state 1 0) -.9501831654548522 1e-10)
    (check-= (square (coordinate last-state)) 1 1e-13)))
