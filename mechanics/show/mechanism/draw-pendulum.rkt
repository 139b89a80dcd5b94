#lang racket/base
;; Pendulums whose rod is rigid, in a vertical plane: SICM 1.6.2, pp. 51-53.

(require "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane-vector.rkt" "../animation/shapes.rkt"
         "../../generic/describe.rkt"
         "../plot/plotted-number.rkt")

(provide draw-pendulum draw-driven-pendulum)

;; θ from the vertical; or x and y of the bob, from the pivot.
(define (draw-pendulum #:length [length 1] #:width [width 300])
  (define l (check-length 'draw-pendulum "the length" length))
  (mechanism
   `(draw-pendulum #:length ,length)
   #:bounds (scaled l '(-1.25 1.25 -1.3 1.3))
   #:width width #:coordinates '(1 2) #:sample '(0.6) #:axes '("θ")
   (lambda (t q)
     (define bob-place (if (= (vector-length q) 1) (below origin l (vector-ref q 0)) q))
     (drawn #:trail (list bob-place)
            #:marks (pendulum-marks origin bob-place l)
            #:shapes (list (mount origin (* 0.25 l) (* 0.07 l)) (swinging origin bob-place l))))))

;; support : -> height of the pivot at a time, or a point
(define (draw-driven-pendulum #:length [length 1] #:support support #:width [width 300])
  (define who 'draw-driven-pendulum)
  (define l (check-length who "the length" length))
  (check-function who support 1 "a function of the time as support")
  (mechanism
   `(draw-driven-pendulum #:length ,length #:support ,(procedure-datum support))
   #:bounds (scaled l '(-1.4 1.4 -1.5 1.5))
   #:width width #:coordinates '(1) #:sample '(0.6) #:axes '("θ")
   (lambda (t q)
     (define p (support-point who (support t)))
     (define bob-place (below p l (vector-ref q 0)))
     (define x (* -0.3 l))
     (drawn #:trail (list bob-place)
            #:marks (list (pendulum-marks p bob-place l)
                          (polyline (list (vector x (* -0.2 l)) (vector x (* 0.2 l)))
                                    #:color (caddr accents) #:arrows 'both)
                          (label (vector x 0.0) "y_s(t)" #:anchor 'left #:color (caddr accents)))
            #:shapes (list (slide p l) (swinging p bob-place l))))))

(define (support-point who x)
  (if (real? x)
      (vector 0.0 (check-number who "the height of the support" x))
      (point-of who "the support" x)))

;; ---------------------------------------------------------------------------

;; A pivot that slides up and down between two rails.
(define (slide p l)
  (define (rail x) (dashed (vector x (* -0.7 l)) (vector x (* 0.7 l))))
  (list (rail (* -0.07 l)) (rail (* 0.07 l))
        (block p (* 0.14 l) (* 0.1 l) #:color faint)))

(define (pendulum-marks p b l)
  (list (dashed p (below p (* 1.1 l) 0.0))
        (swing-mark p (direction (minus b p)) (* 0.4 l) "θ")
        (length-mark p b "l" #:offset (* 0.12 l))
        (name-beside b "m" 16)))
