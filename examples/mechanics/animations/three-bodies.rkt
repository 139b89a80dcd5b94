#lang mechanics
;; Three equal bodies chase each other along a figure of eight.

(require mechanics/animate)
(provide animation)

(define (attraction p q) (/ 1 (sqrt (square (- p q)))))
(define (L (up t (up a b c) (up va vb vc)))
  (+ (* 1/2 (+ (square va) (square vb) (square vc)))
     (attraction a b) (attraction b c) (attraction c a)))

;; Moore's and Chenciner and Montgomery's orbit.
(define start
  (let ([p (up 0.97000436 -0.24308753)] [v (up -0.93240737 -0.86473146)])
    (up 0. (up p (- p) (up 0. 0.)) (up (* -1/2 v) (* -1/2 v) v))))
(define period 6.32591398)
(define motion
  (evolve-trajectory (Lagrangian->state-derivative L) start period #:tolerance 1e-11))

(define animation
  (animate motion (draw-bodies #:masses '(1 1 1) #:range 1.3)
           #:trail #t #:trail-time 1.8 #:title "Three bodies along one curve"))
animation

(module+ main
  (require "save.rkt")
  (save-animations animation "three-bodies.gif"))

(module+ test
  (require rackunit)
  (define (distance p q) (sqrt (square (- p q))))
  (test-case "after a period all are where they were, after a third each where another was"
    (define (place t k) (ref (motion t) 1 k))
    (for ([k 3]) (check-true (< (distance (place 0. k) (place period k)) 1e-5)))
    (for ([k 3])
      (check-true (< (apply min (for/list ([j 3])
                                  (distance (place (/ period 3) k) (place 0. j))))
                     1e-5)))))
