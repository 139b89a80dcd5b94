#lang racket/base
;; Pendulums that swing in space: seen from the side, and, as Foucault's, from above.

(require "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane-vector.rkt" "../animation/projection.rkt"
         "../animation/shapes.rkt")

(provide draw-spherical-pendulum draw-Foucault-pendulum)

;; θ from the bottom and φ; or x, y, z of the bob, z up
(define (draw-spherical-pendulum #:length [length 1] #:width [width 300])
  (define l (check-length 'draw-spherical-pendulum "the length" length))
  (define (place q)
    (if (= (vector-length q) 3)
        (vector->list q)
        (let ([theta (vector-ref q 0)] [phi (vector-ref q 1)])
          (list (* l (sin theta) (cos phi)) (* l (sin theta) (sin phi)) (* -1.0 l (cos theta))))))
  (mechanism
   `(draw-spherical-pendulum #:length ,length)
   #:bounds (scaled l '(-1.15 1.15 -1.35 1.0))
   #:width width #:coordinates '(2 3) #:sample '(0.8 0.3) #:axes '("θ" "φ")
   (lambda (t q)
     (define p (place q))
     (define floor (* -1.05 l))
     (define b (in-view p))
     (define below-bob (in-view (list (car p) (cadr p) floor)))
     (define top (on-vertical 0.0))
     (drawn #:trail (list b)
            #:marks (spherical-marks top b below-bob (on-vertical floor)
                                     (in-view (list (* 0.9 l) 0.0 floor)))
            #:shapes (list (polyline (level-ring floor (* 0.9 l))
                                     #:closed? #t #:width 1 #:color faint)
                           (disc below-bob (* 0.03 l) #:fill faint #:color #f)
                           (mount top (* 0.25 l) (* 0.07 l))
                           (swinging top b l))))))

;; foot : below the top, on the floor, where x-end is the end of the x axis
(define (spherical-marks top b below-bob foot x-end)
  (list (dashed top foot)
        (polyline (list b below-bob) #:width 1 #:style 'dot #:color faint)
        (thin foot x-end #:arrows 'end)
        (thin foot below-bob)
        (label (between (between top foot 0.3) (between top b 0.3) 0.6) "θ"
               #:anchor 'below #:color (cadr accents))
        (label (between foot (between x-end below-bob 0.5) 0.45) "φ" #:color (cadr accents))
        (label (between top b 0.5) "l" #:anchor 'right)
        (name-beside b "m")))

;; x to the east and y to the north, from the place of rest
(define (draw-Foucault-pendulum #:range [range 1] #:width [width 300])
  (define far (check-length 'draw-Foucault-pendulum "the range" range))
  (mechanism
   `(draw-Foucault-pendulum #:range ,range)
   #:bounds (scaled far '(-1.3 1.3 -1.3 1.3))
   #:width width #:coordinates '(2) #:sample (list (* 0.6 far) (* 0.45 far)) #:axes '("x" "y")
   (lambda (t q)
     (define foot (vector (at-x q) 0.0))
     (define (arrow from to) (thin from to #:color (cadr accents) #:arrows 'end))
     (drawn #:trail (list q)
            #:marks (list (arrow origin foot)
                          (arrow foot q)
                          (label (between origin foot 0.5) "x" #:anchor 'below)
                          (label (between foot q 0.5) "y" #:anchor 'right)
                          (label q "m" #:anchor 'above #:shift #(0 8)))
            #:shapes (list (disc origin (* 1.05 far) #:color faint #:width 2)
                           (for/list ([name '("E" "N" "W" "S")]
                                      [p '(#(1.17 0.0) #(0.0 1.17) #(-1.17 0.0) #(0.0 -1.17))])
                             (label (times far p) name #:italic? #f #:size 13 #:color faint))
                           (thin origin q)
                           (disc origin (* 0.02 far) #:fill faint #:color #f)
                           (bob q (* 0.07 far)))))))
