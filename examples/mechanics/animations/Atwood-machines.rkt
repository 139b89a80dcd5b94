#lang mechanics
;; A weight against two that hang from a pulley: it is as heavy as both, and yet it sinks
;; (SICM 1.10).

(require mechanics/animate)
(provide animation)

;; Depths; the strings are constraints.
(define ((L-three m1 m2 m3 g) (up t (up x1 y x2 x3) (up v1 vy v2 v3)))
  (+ (* 1/2 m1 (square v1)) (* 1/2 m2 (square v2)) (* 1/2 m3 (square v3))
     (* g (+ (* m1 x1) (* m2 x2) (* m3 x3)))))
(define strings
  (list (holonomic (lambda (t (up x1 y x2 x3)) (- (+ x1 y) 2.)))
        (holonomic (lambda (t (up x1 y x2 x3)) (- (+ (- x2 y) (- x3 y)) 1.4)))))

(define motion
  (evolve-trajectory (constrained-state-derivative (L-three 4. 1. 3. 9.8) strings)
                     (up 0. (up 0.7 1.3 2.3 1.7) (up 0. 0. 0. 0.)) 0.5))

(define animation
  (animate motion (draw-Atwood-machine #:length 3 #:masses '(4 1 3))
           #:speed 1/6 #:title "One weight against two of the same sum"))
animation

(module+ main
  (require "save.rkt")
  (save-animations animation "Atwood-machines.gif"))

(module+ test
  (require rackunit)
  (define q (coordinate (motion 0.5)))
  (test-case "the first weight sinks, and the strings keep their lengths"
    (check-true (> (ref q 0) 0.7))
    (check-= (+ (ref q 0) (ref q 1)) 2 1e-8)
    (check-= (- (+ (ref q 2) (ref q 3)) (* 2 (ref q 1))) 1.4 1e-8))
  (test-case "the acceleration is that of the formula"
    (define a (* 9.8 (/ (- (* 4 4) (* 4 1 3)) (+ (* 4 4) (* 4 1 3)))))
    (check-= (ref q 0) (+ 0.7 (* 1/2 a 1/4)) 1e-8)))
