#lang racket/base
;; Sketches of systems that have programs of their own and no drawing that moves: a knife edge,
;; a mass on ball, string or wire, a slack string, a moon.

(require mechanics/animate
         "sketch-parts.rkt")

(provide knife-edge supports slack-string moon)

;; From above, downhill to the right; the cycloid that it goes along.
(define (knife-edge)
  (define (cycloid a) (at (* 0.5 (expt (sin a) 2)) (* 0.5 (- a (* (sin a) (cos a))))))
  (define b (cycloid 1.1))
  (define (along r) (at (+ (car b) (* r (cos 1.1))) (+ (cdr b) (* r (sin 1.1)))))
  (sketch -0.4 1.7 -0.35 2.1 #:width 280
          (axes 1.5 1.9 "x" "y")
          (label (at 1.1 0.12) "g sin α" #:color orange)
          (polyline (for/list ([k 61]) (cycloid (* k pi 1/50)))
                    #:width 1 #:style 'long-dash #:color gray)
          (polyline (list (along -0.3) (along 0.3)) #:width 5 #:color blue)
          (polyline (list b (at (+ (car b) 0.7) (cdr b))) #:width 1 #:color gray)
          (angle-mark b 0 1.1 0.4 "θ")
          (label b "(x, y)" #:anchor 'left)))

(define (supports)
  (define (mass x angle) (at (+ x (sin angle)) (cos angle)))
  (define (polar x angle)
    (list (polyline (list (at x 0) (at x 1.35)) #:width 1 #:style 'long-dash #:color gray)
          (polyline (list (at x 0) (mass x angle)) #:width 1)
          (angle-mark (at x 0) (- (/ pi 2) angle) (/ pi 2) 0.5 "θ")
          (bob (mass x angle) 0.1)))
  (sketch -1.4 7.6 -1.7 1.6 #:width 520
          (disc (at 0 0) 1 #:fill '(225 230 238)) (polar 0 0.6)
          (label (at 0 -1.35) "a ball pushes" #:italic? #f)
          (disc (at 3.1 0) 0.05 #:fill "black") (polar 3.1 2.2)
          (disc (at 3.1 0) 1 #:width 1 #:color gray)
          (label (at 3.1 -1.35) "a string pulls" #:italic? #f)
          (disc (at 6.2 0) 1 #:width 4) (polar 6.2 0.9)
          (label (at 6.2 -1.35) "a wire does both" #:italic? #f)))

;; The circle is left where the string goes slack; it is taut again below.
(define (slack-string)
  (define start (at (cos 0.6) (sin 0.6)))
  (define (flight t)
    (at (+ (car start) (* -0.9 (sin 0.6) t)) (+ (cdr start) (* 0.9 (cos 0.6) t) (* -1/2 t t))))
  (define now (flight 1.1))
  (sketch -1.5 1.6 -1.3 1.3 #:width 280
          (disc (at 0 0) 1 #:width 1 #:color gray)
          (disc (at 0 0) 0.04 #:fill "black")
          (polyline (for/list ([k 31]) (let ([a (+ -1.5 (* k 0.07))]) (at (cos a) (sin a))))
                    #:color blue)
          (polyline (for/list ([k 41]) (flight (* k 0.047)))
                    #:color orange #:style 'long-dash)
          (polyline (list (at 0 0) (at -0.12 0.3) (at 0.1 0.45) now) #:width 1)
          (bob now 0.07 #:label "m")
          (label start "slack" #:anchor 'right #:italic? #f)
          (vector-arrow (at 1.3 -0.5) (at 1.3 -1.05) #:label "g")))

(define (moon)
  (define place (at (* 2 (cos 0.7)) (* 1.5 (sin 0.7))))
  (define (from-it angle r)
    (at (+ (car place) (* r (cos angle))) (+ (cdr place) (* r (sin angle)))))
  (sketch -2.4 3.1 -1.7 2.1 #:width 360
          (ellipse (at 0 0) 2 1.5 #:style 'long-dash #:color gray #:width 1)
          (disc (at 0.5 0) 0.2 #:fill '(240 180 40))
          (polyline (list (at 0.5 0) place) #:width 1)
          (polyline (list (at 0.5 0) (at 2.6 0)) #:width 1 #:color gray)
          (angle-mark (at 0.5 0) 0 (atan (cdr place) (- (car place) 0.5)) 0.6 "f")
          (label (at 0.85 0.6) "R")
          (ellipse place 0.4 0.24 #:angle 1.3 #:fill '(215 220 228))
          (polyline (list place (from-it 0 1)) #:width 1 #:color gray)
          (polyline (list place (from-it 1.3 0.9)) #:width 1 #:color blue #:arrows 'end)
          (angle-mark place 0 1.3 0.6 "θ")))
