#lang mechanics
;; A pendulum stands upside down while its pivot is shaken fast enough (SICM 1.6.2; 1.7).

(require mechanics/animate mechanics/book)
(provide animation)

(define-values (m l g A omega) (values 1. 1. 9.8 0.1 100.))

;; 0.6 from the top at first.
(define standing
  (evolve-trajectory (pend-state-derivative m l g A omega)
                     (up 0. (- :pi 0.6) 0.) 4.))
(define (support t) (* A (cos (* omega t))))

(define animation
  (animate standing
           (draw-driven-pendulum #:length l #:support support)
           #:speed 1/2 #:trail #t #:trail-time 1 #:phase-portrait #t
           #:title "Upright, while the pivot is shaken"))
animation

(module+ main
  (require "save.rkt")
  (save-animations animation "upright-pendulum.gif"))

(module+ test
  (require rackunit)
  ;; It stays up if A²ω² > 2 g l.
  (define (lowest omega)
    (define motion
      (evolve-trajectory (pend-state-derivative m l g A omega) (up 0. (- :pi 0.6) 0.) 4.))
    (apply min (map (lambda (s) (coordinate s)) (trajectory-states motion))))
  (test-case "it oscillates about the top, and falls where the shaking is slower"
    (check-true (> (lowest 100.) 2))
    (check-true (< (lowest 30.) 1))))
