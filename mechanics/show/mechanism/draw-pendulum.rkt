#lang racket/base
;; Pendulums whose rod is rigid, in a vertical plane: SICM 1.6.2, pp. 51-53.

(require "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane.rkt" "../animation/shapes.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../numeric/constants.rkt"
         "../plot/coordinate.rkt")

(provide draw-pendulum draw-driven-pendulum)

;; θ from the vertical; or x and y of the bob, from the pivot.
(define (draw-pendulum #:length [length 1] #:width [width 300])
  (define l (check-length 'draw-pendulum "the length" length))
  (define (bob-of q)
    (if (= (vector-length q) 1) (below origin l (vector-ref q 0)) q))
  (mechanism
   `(draw-pendulum #:length ,length)
   #:bounds (for/list ([x '(-1.25 1.25 -1.3 1.3)]) (* l x))
   #:width width #:coordinates '(1 2) #:sample '(0.6) #:axes '("θ")
   #:trail (lambda (t q) (list (bob-of q)))
   #:marks (lambda (t q) (pendulum-marks origin (bob-of q) l))
   (lambda (t q)
     (list (support origin l) (swinging origin (bob-of q) l)))))

;; support : -> height of the pivot at a time, or a point
(define (draw-driven-pendulum #:length [length 1] #:support support #:width [width 300])
  (define who 'draw-driven-pendulum)
  (define l (check-length who "the length" length))
  (unless (and (procedure? support) (accepts? support 1))
    (raise-other-function who "a function of the time as support" support))
  (define (pivot-at t) (support-point who (support t)))
  (define (bob-of t q) (below (pivot-at t) l (vector-ref q 0)))
  (mechanism
   `(draw-driven-pendulum #:length ,length #:support ,(procedure-datum support))
   #:bounds (for/list ([x '(-1.4 1.4 -1.5 1.5)]) (* l x))
   #:width width #:coordinates '(1) #:sample '(0.6) #:axes '("θ")
   #:trail (lambda (t q) (list (bob-of t q)))
   #:marks (lambda (t q)
             (list (pendulum-marks (pivot-at t) (bob-of t q) l)
                   (polyline (list (vector (* -0.3 l) (* -0.2 l)) (vector (* -0.3 l) (* 0.2 l)))
                             #:color (caddr accents) #:arrows 'both)
                   (label (vector (* -0.3 l) 0.0) "y_s(t)" #:anchor 'left
                          #:color (caddr accents))))
   (lambda (t q)
     (define p (pivot-at t))
     (list (slide p l) (swinging p (bob-of t q) l)))))

(define origin (vector 0.0 0.0))

(define (support-point who x)
  (if (real? x)
      (vector 0.0 (check-number who "the height of the support" x))
      (point-of who (lambda () "the support") x)))

;; ---------------------------------------------------------------------------

;; A ceiling above a pivot.
(define (support p l)
  (list (wall (add p (vector (* -0.25 l) 0.0)) (add p (vector (* 0.25 l) 0.0)) #:depth (* 0.07 l))))

;; A pivot that slides up and down between two rails.
(define (slide p l)
  (define (rail x) (polyline (list (vector x (* -0.7 l)) (vector x (* 0.7 l))) #:width 1
                             #:color faint #:style 'long-dash))
  (list (rail (* -0.07 l)) (rail (* 0.07 l))
        (block p (* 0.14 l) (* 0.1 l) #:color faint)))

(define (swinging p b l)
  (list (rod p b) (pivot p (* 0.025 l)) (bob b (* 0.08 l))))

(define (pendulum-marks p b l)
  (define d (minus b p))
  (define angle (atan (at-y d) (at-x d)))
  (list (polyline (list p (below p (* 1.1 l) 0.0)) #:width 1 #:style 'long-dash #:color faint)
        (angle-mark p (- :pi/2) angle (* 0.4 l) "θ")
        (length-mark p b "l" #:offset (* 0.12 l))
        (label b "m" #:anchor 'right #:shift #(16 0))))
