#lang mechanics
;; Sections of the periodically driven pendulum, for the figures of section 3.6.1 and chapter 4: its
;; state once in each period of the drive.

(require mechanics/plot mechanics/book)

(provide strobe-section strobe-map draw-branch)

(define omega_0 (sqrt 9.8))

;; m = l = 1, the amplitude A in metres, the frequency in units of that of small oscillations; a
;; negative one leads back.
(define (strobe-map A ratio) (driven-pendulum-map 1. 1. 9.8 A (* ratio omega_0)))

;; starts : lists (θ p)
(define (strobe-section A ratio p-max starts n)
  (define win (frame :-pi :pi (- p-max) p-max #:x-label "θ" #:y-label "p_θ"))
  (explore-map win (strobe-map A ratio) n
               #:starts (map (lambda (start) (apply up start)) starts)))

;; Points of a manifold, each joined to the next but where the angle passes ±π.
(define (draw-branch picture points #:color color)
  (for ([v points] [w (cdr points)] #:when (< (abs (- (ref v 0) (ref w 0))) 1))
    (plot-line picture (ref v 0) (ref v 1) (ref w 0) (ref w 1) #:color color)))
