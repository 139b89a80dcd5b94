#lang racket/base
;; Diagrams of the systems that the manual works out: the drawings of the library with their
;; marks, and sketches where there is no drawing.

(require file/convertible
         mechanics/animate
         scribble/base
         "sketch-parts.rkt" "sketches.rkt"
         (only-in "../../mechanics/show/animation/on-demand.rkt" why-no-pictures))

(provide system-diagram)

;; The diagram of that name, where pictures can be drawn.
(define (system-diagram name)
  (define make (hash-ref diagrams name))
  (if (why-no-pictures) '() (nested #:style 'inset (elem (illustration (make) name)))))

;; A pict that in plain text is its name.
(struct illustration (pict name)
  #:property prop:convertible
  (lambda (i request default)
    (if (eq? request 'text)
        (format "(a diagram: ~a)" (illustration-name i))
        (convert (illustration-pict i) request default))))

;; ---------------------------------------------------------------------------
;; Paths

(define (varied-path)
  (define (straight t) (+ 0.4 (* 0.45 t)))
  (sketch -0.5 4.4 -0.4 2.7 (axes 4.2 2.5 "t" "x")
          (curve straight 0.5 3.5)
          (curve (lambda (t) (+ (straight t) (* 0.5 (sin (* pi (/ (- t 0.5) 3)))))) 0.5 3.5
                 #:color orange #:style 'long-dash)
          (bob (at 0.5 (straight 0.5)) 0.06) (bob (at 3.5 (straight 3.5)) 0.06)
          (label (at 2.4 1.2) "q" #:color blue)
          (label (at 1.5 1.9) "q + ε η" #:color orange)))

(define (straight-line)
  (sketch -0.5 4.4 -0.4 2.2 (axes 4.2 2 "x" "y")
          (polyline (list (at 0.3 0.4) (at 4 1.7)) #:style 'long-dash #:color gray #:width 1)
          (bob (at 1.5 0.82) 0.09 #:label "m" #:anchor 'below)
          (vector-arrow (at 1.5 0.82) (at 2.7 1.24) #:label "v")))

(define (turning-axes)
  (define (turned r) (at (* r (cos 0.45)) (* r (sin 0.45))))
  (sketch -1.4 2.6 -0.4 2.5 (axes 2.3 2.2 "x" "y")
          (vector-arrow (at 0 0) (turned 2.3) #:label "x'" #:color blue)
          (vector-arrow (at 0 0) (at (* -2.2 (sin 0.45)) (* 2.2 (cos 0.45))) #:label "y'"
                        #:color blue)
          (angle-mark (at 0 0) 0 0.45 1.3 "Ω t")
          (bob (at 1.2 1.6) 0.07 #:label "m")))

(define (polar)
  (sketch -0.4 3.2 -0.4 2.2 (axes 3 2 "x" "y")
          (polyline (list (at 0 0) (at 2.2 1.3)) #:width 1.5)
          (bob (at 2.2 1.3) 0.08 #:label "m")
          (label (at 1.1 0.85) "r") (angle-mark (at 0 0) 0 (atan 1.3 2.2) 1.1 "θ")))

(define (two-particles)
  (sketch -0.4 3.4 -0.4 2.3 (axes 3.2 2.1 "x" "y")
          (vector-arrow (at 0 0) (at 1 1.6) #:color blue)
          (vector-arrow (at 0 0) (at 2.5 0.8) #:color blue)
          (bob (at 1 1.6) 0.08) (bob (at 2.5 0.8) 0.08)
          (label (at 0.35 0.95) "r_1" #:color blue) (label (at 1.4 0.25) "r_2" #:color blue)
          (vector-arrow (at 1 1.6) (at 1.7 1.9) #:label "F_1")
          (vector-arrow (at 2.5 0.8) (at 2.9 1.5) #:label "F_2")))

(define (three-bodies)
  (sketch -2.6 2.6 -1 1.9 #:width 360
          (axes 2.4 1.7 "x" "y")
          (disc (at -0.5 0) 0.18 #:fill '(240 180 40)) (bob (at 1.9 0) 0.1)
          (label (at -0.5 -0.2) "m_0" #:anchor 'below) (label (at 1.9 -0.12) "m_1" #:anchor 'below)
          (bob (at 0.9 1.1) 0.06 #:color orange #:label "m")
          (polyline (list (at -0.5 0) (at 0.9 1.1) (at 1.9 0))
                    #:width 1 #:style 'dot #:color gray)))

;; ---------------------------------------------------------------------------
;; Forces

(define (driven-oscillator)
  (sketch -0.2 3.6 -0.6 0.7 #:width 360
          (wall (at 0 -0.5) (at 0 0.6)) (spring (at 0 0.15) (at 1.6 0.15) #:width 0.22)
          (polyline (list (at 0 -0.25) (at 0.7 -0.25)) #:width 1.5)
          (polyline (list (at 1.1 -0.4) (at 0.65 -0.4) (at 0.65 -0.1) (at 1.1 -0.1)) #:width 1.5)
          (polyline (list (at 0.8 -0.25) (at 1.6 -0.25)) #:width 1.5)
          (polyline (list (at 0.8 -0.36) (at 0.8 -0.14)) #:width 2)
          (block (at 1.95 -0.03) 0.7 0.7) (label (at 1.95 0.32) "m" #:anchor 'above)
          (label (at 0.8 0.3) "k" #:anchor 'above) (label (at 0.9 -0.42) "b" #:anchor 'below)
          (vector-arrow (at 2.3 0) (at 3 0) #:label "F(t)")))

(define (pendulum-with-weight)
  (define b (at (sin 0.6) (- (cos 0.6))))
  (sketch -0.5 1.5 -1.5 0.15 #:width 240
          (wall (at -0.3 0) (at 0.3 0)) (rod (at 0 0) b) (bob b 0.07 #:label "m")
          (polyline (list (at 0 0) (at 0 -1)) #:width 1 #:style 'long-dash #:color gray)
          (angle-mark (at 0 0) (/ pi -2) (- 0.6 (/ pi 2)) 0.45 "θ")
          (vector-arrow b (at (car b) (- (cdr b) 0.5)) #:label "m g")))

(define (lever)
  (define-values (a b) (values (at -1.2 0.25) (at 2 -0.42)))
  (sketch -1.9 2.7 -1.5 0.7 #:width 340
          (rod a b #:width 4)
          (polyline (list (at 0 0) (at -0.2 -0.5) (at 0.2 -0.5)) #:closed? #t #:fill gray #:width 1)
          (vector-arrow a (at -1.2 -0.75) #:label "A") (vector-arrow b (at 2 -1.1) #:label "B")
          (label (at -0.6 0.25) "a") (label (at 1 -0.05) "b")
          (polyline (list (at 0 0) (at 2.3 0)) #:width 1 #:style 'long-dash #:color gray)
          (label (at 2.3 -0.2) "φ" #:color orange)))

(define (loop)
  (define (ramp x) (+ -1 (* 0.32 (expt (max 0 (- -0.2 x)) 2))))
  (sketch -3.4 1.9 -1.2 2.2 #:width 360
          (curve ramp -3.2 1.6 #:color gray)
          (disc (at 0 0) 1 #:color gray #:width 2)
          (bob (at 0.8 0.6) 0.1 #:label "m")
          (polyline (list (at 0 0) (at 0.8 0.6)) #:width 1)
          (polyline (list (at 0 0) (at 0 -1)) #:width 1 #:style 'long-dash #:color gray)
          (angle-mark (at 0 0) (/ pi -2) (atan 0.6 0.8) 0.4 "θ") (label (at 0.3 0.5) "R")
          (length-mark (at -3.2 -1) (at -3.2 1.88) "h")))

(define (turntable)
  (sketch -2.2 2.4 -1.1 1.4 #:width 340
          (ellipse (at 0 0) 2 0.7 #:fill '(225 230 238))
          (polyline (list (at 0 0) (at 0 1.2)) #:width 1 #:color gray #:arrows 'end)
          (label (at 0 1.2) "Ω" #:anchor 'right #:color orange)
          (disc (at 1 0.12) 0.28 #:fill blue #:width 1) (label (at 1 0.4) "m, R" #:anchor 'above)
          (polyline (list (at 0 0) (at 1 -0.15)) #:width 1 #:arrows 'end)
          (label (at 0.45 -0.25) "(x, y)")))

;; ---------------------------------------------------------------------------

(define diagrams
  (hasheq 'varied-path varied-path
          'straight-line straight-line
          'oscillator (lambda () (diagram (draw-oscillator)))
          'orbit (lambda () (diagram (draw-orbit)))
          'turning-axes turning-axes
          'polar polar
          'two-particles two-particles
          'three-bodies three-bodies
          'pendulum (lambda () (diagram (draw-pendulum)))
          'driven-pendulum
          (lambda () (diagram (draw-driven-pendulum #:support (lambda (t) 0.1))))
          'driven-oscillator driven-oscillator
          'pendulum-with-weight pendulum-with-weight
          'ring (lambda () (diagram (draw-bead-on-ring #:angular-velocity 1)))
          'lever lever
          'Atwood (lambda () (diagram (draw-Atwood-machine)))
          'double-Atwood (lambda () (diagram (draw-Atwood-machine #:masses '(4 1 3)) #:size 300))
          'ladder (lambda () (diagram (draw-ladder)))
          'loop loop
          'supports supports
          'slack-string slack-string
          'knife-edge knife-edge
          'moon moon
          'spherical-pendulum (lambda () (diagram (draw-spherical-pendulum)))
          'sleigh (lambda () (diagram (draw-sleigh)))
          'coin (lambda () (diagram (draw-coin)))
          'turntable turntable
          'brick (lambda () (diagram (draw-brick)))
          'top (lambda () (diagram (draw-top)))
          'chain (lambda () (diagram (draw-pendulum-chain)))))
