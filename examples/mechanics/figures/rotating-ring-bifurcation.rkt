#lang mechanics
;; A bead on a ring that rotates about its vertical diameter, in pictures: where it can
;; rest, as the ring turns faster, and how it moves when the ring is slow and fast.

(require mechanics/plot)

(define ((L-ring m R omega g) (up t theta thetadot))
  (+ (* 1/2 m (square R) (+ (square thetadot) (square (* omega (sin theta)))))
     (* m g R (cos theta))))
(define critical (sqrt 9.8))            ; R = 1, g = 9.8

;; Angles of equilibrium against the angular velocity of the ring.  Those that the frequency
;; of small oscillations shows not to be stable are dotted.
(define (force omega theta) (((partial 1) (L-ring 1.0 1.0 omega 9.8)) (up 0 theta 0)))
(define (aside omega) (acos (/ 9.8 (square omega))))
(define bifurcation
  (frame 0 8 -3.5 3.5 #:width 500 #:height 300 #:x-label "ω" #:y-label "θ"))
(plot-line bifurcation 0 0 critical 0 #:width 2)
(plot-line bifurcation critical 0 8 0 #:style 'dot)
(for ([sign '(1 -1)])
  (plot-function bifurcation (lambda (omega) (* sign (aside omega))) critical 8 0.01 #:width 2)
  (plot-line bifurcation 0 (* sign :pi) 8 (* sign :pi) #:style 'dot))

bifurcation

;; Motions in the plane of θ and its rate: from rest at several angles, and over the top
;; at several speeds.
(define (portrait omega)
  (define f (frame :-pi :pi -10 10 #:width 400 #:height 300
                   #:title (format "ω = ~a" omega) #:x-label "θ" #:y-label "rate of θ"))
  (define slope (Lagrangian->state-derivative (L-ring 1.0 1.0 omega 9.8)))
  (define (draw theta rate color)
    (plot-trajectory f (evolve-trajectory slope (up 0.0 theta rate) 6.0 #:tolerance 1e-9)
                     coordinate velocity #:color color))
  (for* ([start '(0.5 1.0 1.5 2.0 2.5 3.0)] [sign '(1 -1)]) (draw (* sign start) 0.0 'blue))
  (for* ([rate '(1.0 3.0 5.0)] [sign '(1 -1)]) (draw (* sign :-pi) (* sign rate) 'gray))
  f)
(define slow (portrait 2.0))
(define fast (portrait 5.0))

slow
fast

(module+ main
  (require "save.rkt")
  (save-figure bifurcation "rotating-ring-bifurcation.png"))

(module+ test
  (require rackunit)
  (test-case "no force remains at the angles drawn"
    (for ([omega '(3.2 4.0 5.0 8.0)])
      (check-= (force omega (aside omega)) 0 1e-12)))
  (test-case "the branches meet at the bottom, where the ring has its critical velocity"
    (define ends (map car (filter (lambda (c) (> (length c) 2)) (frame-curves bifurcation))))
    (check-equal? (length ends) 2)
    (for ([p ends]) (check-= (ref p 1) 0 1e-6)))
  ;; Along a motion the energy on the ring is that of its start.
  (define (energy omega) (Lagrangian->energy (L-ring 1.0 1.0 omega 9.8)))
  (test-case "curves are lines of constant energy"
    (for ([f (list slow fast)] [omega '(2.0 5.0)])
      (for ([curve (frame-curves f)])
        (define E (energy omega))
        (define (at p) (E (up 0 (ref p 0) (ref p 1))))
        (for ([p curve]) (check-= (at p) (at (car curve)) 1e-6)))))
  (test-case "only in the fast ring a bead stays on one side of the bottom"
    (define (one-sided? curve)
      (or (andmap (lambda (p) (> (ref p 0) 0)) curve)
          (andmap (lambda (p) (< (ref p 0) 0)) curve)))
    ;; curves cut off by the frame's edge are not whole motions
    (define (within-a-turn? curve) (andmap (lambda (p) (< (abs (ref p 0)) 3)) curve))
    (define (one-sided f)
      (filter one-sided? (filter within-a-turn? (frame-curves f))))
    (check-equal? (length (one-sided slow)) 0)
    (check-equal? (length (one-sided fast)) 6)))
