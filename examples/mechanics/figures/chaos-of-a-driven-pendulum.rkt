#lang mechanics
;; Where a driven pendulum is chaotic: what a stroboscopic section shows point by point, as one
;; picture of MEGNO, for which displacements are followed beside each motion.

(require mechanics/plot)

(define (driven (up t q p))
  (up 1 p (* (sin q) (- (* 0.3 (cos t)) 1))))
(define (start q p) (up 0 q p))
(define duration (* 30 :2pi))

(define win (frame :-pi :pi -3 3 #:x-label "θ" #:y-label "p_θ"))
(chaos-map win driven duration #:samples 30 #:state start #:indicator 'MEGNO #:tolerance 1e-8
           #:jobs 1)

;; Two of these motions, in the island and in the sea.
(define (MEGNO q) (chaos-indicator driven (start q 0) duration #:indicator 'MEGNO))
(MEGNO 0.5)
(MEGNO 3.0)

(module+ main
  (require "save.rkt")
  (save-figure win "chaos-of-a-driven-pendulum.png"))

(module+ test
  (require rackunit)
  (test-case "an island in the sea"
    (check-true (< (MEGNO 0.5) 2.5))
    (check-true (> (MEGNO 3.0) 4))))
