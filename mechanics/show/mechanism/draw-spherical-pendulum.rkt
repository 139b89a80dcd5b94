#lang racket/base
;; Pendulums that swing in space: seen from the side, and, as Foucault's, from above.

(require "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane.rkt" "../animation/projection.rkt" "../animation/shapes.rkt")

(provide draw-spherical-pendulum draw-Foucault-pendulum)

;; θ from the bottom and φ; or x, y, z of the bob, z up
(define (draw-spherical-pendulum #:length [length 1] #:width [width 300])
  (define l (check-length 'draw-spherical-pendulum "the length" length))
  (define (place q)
    (if (= (vector-length q) 3)
        (vector->list q)
        (let ([theta (vector-ref q 0)] [phi (vector-ref q 1)])
          (list (* l (sin theta) (cos phi)) (* l (sin theta) (sin phi)) (* -1.0 l (cos theta))))))
  (define (seen q) (apply in-view (place q)))
  (define top (in-view 0.0 0.0 0.0))
  (mechanism
   `(draw-spherical-pendulum #:length ,length)
   #:bounds (for/list ([x '(-1.15 1.15 -1.35 1.0)]) (* l x))
   #:width width #:coordinates '(2 3) #:sample '(0.8 0.3) #:axes '("θ" "φ")
   #:trail (lambda (t q) (list (seen q)))
   #:marks (lambda (t q) (spherical-marks (place q) l))
   (lambda (t q)
     (define b (place q))
     (define floor (in-view (car b) (cadr b) (* -1.05 l)))
     (list (polyline (space-ring (list 0.0 0.0 (* -1.05 l)) (list (* 0.9 l) 0.0 0.0)
                                 (list 0.0 (* 0.9 l) 0.0))
                     #:closed? #t #:width 1 #:color faint)
           (disc floor (* 0.03 l) #:fill faint #:color #f)
           (wall (add top (vector (* -0.25 l) 0.0)) (add top (vector (* 0.25 l) 0.0))
                 #:depth (* 0.07 l))
           (rod top (seen q)) (pivot top (* 0.025 l)) (bob (seen q) (* 0.08 l))))))

(define (spherical-marks b l)
  (define top (in-view 0.0 0.0 0.0))
  (define foot (in-view 0.0 0.0 (* -1.05 l)))
  (define below-bob (in-view (car b) (cadr b) (* -1.05 l)))
  (define bob-place (apply in-view b))
  (list (polyline (list top foot) #:width 1 #:style 'long-dash #:color faint)
        (polyline (list bob-place below-bob) #:width 1 #:style 'dot #:color faint)
        (polyline (list foot (in-view (* 0.9 l) 0.0 (* -1.05 l))) #:width 1 #:color faint
                  #:arrows 'end)
        (polyline (list foot below-bob) #:width 1 #:color faint)
        (label (between (between top foot 0.3) (between top bob-place 0.3) 0.6) "θ"
               #:anchor 'below #:color (cadr accents))
        (label (between foot (between (in-view (* 0.9 l) 0.0 (* -1.05 l)) below-bob 0.5) 0.45) "φ"
               #:color (cadr accents))
        (label (between top bob-place 0.5) "l" #:anchor 'right)
        (label bob-place "m" #:anchor 'right #:shift #(13 0))))

;; x to the east and y to the north, from the place of rest
(define (draw-Foucault-pendulum #:range [range 1] #:width [width 300])
  (define far (check-length 'draw-Foucault-pendulum "the range" range))
  (define center (vector 0.0 0.0))
  (mechanism
   `(draw-Foucault-pendulum #:range ,range)
   #:bounds (for/list ([x '(-1.3 1.3 -1.3 1.3)]) (* far x))
   #:width width #:coordinates '(2) #:sample (list (* 0.6 far) (* 0.45 far)) #:axes '("x" "y")
   #:trail (lambda (t q) (list q))
   #:marks (lambda (t q)
             (define foot (vector (at-x q) 0.0))
             (list (polyline (list center foot) #:width 1 #:color (cadr accents) #:arrows 'end)
                   (polyline (list foot q) #:width 1 #:color (cadr accents) #:arrows 'end)
                   (label (between center foot 0.5) "x" #:anchor 'below)
                   (label (between foot q 0.5) "y" #:anchor 'right)
                   (label q "m" #:anchor 'above #:shift #(0 8))))
   (lambda (t q)
     (list (disc center (* 1.05 far) #:color faint #:width 2)
           (for/list ([name '("E" "N" "W" "S")] [x '(1.17 0.0 -1.17 0.0)] [y '(0.0 1.17 0.0 -1.17)])
             (label (vector (* far x) (* far y)) name #:italic? #f #:size 13 #:color faint))
           (polyline (list center q) #:width 1 #:color faint)
           (disc center (* 0.02 far) #:fill faint #:color #f)
           (bob q (* 0.07 far))))))
