#lang mechanics
;; A heavy top whose axis loops as it goes round (SICM 2.10).

(require mechanics/animate mechanics/book)
(provide animation)

(define-values (A C gMR) (values 6.96e-4 1.32e-4 0.112))
(define L (L-axisymmetric-top A C gMR))

;; Let go at the tilt 0.4 against the sense in which it goes round.
(define motion
  (evolve-trajectory (Lagrangian->state-derivative L)
                     (up 0. (up 0.4 0. 0.) (up 0. -10. 200.)) 1.))

(define animation
  (animate motion (draw-top) #:speed 1/8 #:trail #t #:phase-portrait #t
           #:title "A heavy top"))
animation

(module+ main
  (require "save.rkt")
  (save-animations animation "heavy-top.gif"))

(module+ test
  (require rackunit)
  (test-case "the tilt keeps to its range"
    (define range (nutation-range A C gMR (motion 0.)))
    (for ([t (in-range 0 1 1/50)])
      (check-true (<= (- (car range) 1e-6) (ref (motion t) 1 0) (+ (cadr range) 1e-6))))))
