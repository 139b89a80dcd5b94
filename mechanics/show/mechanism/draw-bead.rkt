#lang racket/base
;; Beads: on a ring that turns about its vertical diameter, and on a track in a plane.

(require "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane.rkt" "../animation/projection.rkt" "../animation/shapes.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../numeric/constants.rkt"
         "../plot/coordinate.rkt")

(provide draw-bead-on-ring draw-bead-on-track)

;; θ from the bottom; the ring has turned by the angular velocity times the time.
(define (draw-bead-on-ring #:radius [radius 1] #:angular-velocity [omega 0] #:width [width 300])
  (define who 'draw-bead-on-ring)
  (define r (check-length who "the radius" radius))
  (define rate (check-number who "the angular velocity" omega))
  (define (place t theta)
    (define turn (* rate t))
    (values (* r (sin theta) (cos turn)) (* r (sin theta) (sin turn)) (* -1.0 r (cos theta))))
  (define (seen t theta) (call-with-values (lambda () (place t theta)) in-view))
  (define (half t from) (for/list ([k (in-range 33)]) (seen t (+ from (/ (* pi k) 32)))))
  (mechanism
   `(draw-bead-on-ring #:radius ,radius #:angular-velocity ,omega)
   #:bounds (for/list ([x '(-1.3 1.3 -1.4 1.4)]) (* r x))
   #:width width #:coordinates '(1) #:sample '(0.9) #:axes '("θ")
   #:trail (lambda (t q) (list (seen t (vector-ref q 0))))
   #:marks (lambda (t q) (ring-marks (lambda (angle) (seen t angle)) (vector-ref q 0) r))
   (lambda (t q)
     (define theta (vector-ref q 0))
     (define (axis from to) (polyline (list (in-view 0.0 0.0 from) (in-view 0.0 0.0 to))
                                      #:color faint #:width 3))
     (list (axis (* -1.35 r) (* -1.0 r)) (axis r (* 1.35 r))
           ;; the half away from the eye first
           (for/list ([from (in-list (sort '(0.0 1.0) < #:key
                                           (lambda (side)
                                             (call-with-values
                                              (lambda () (place t (+ :pi/2 (* side pi))))
                                              nearness))))]
                      [width (in-list '(2 4))])
             (polyline (half t (* from pi)) #:width width))
           (bob (seen t theta) (* 0.08 r))))))

;; seen : angle from the bottom -> point
(define (ring-marks seen theta r)
  (define center (in-view 0.0 0.0 0.0))
  (define arc
    (for/list ([k (in-range 17)]) (between center (seen (* theta (/ k 16.0))) 0.45)))
  (list (polyline (list center (seen 0.0)) #:width 1 #:style 'long-dash #:color faint)
        (polyline (list center (seen theta)) #:width 1 #:color faint)
        (polyline arc #:width 1.2 #:color (cadr accents) #:arrows 'end)
        (label (between center (seen (/ theta 2)) 0.6) "θ" #:color (cadr accents))
        (label (between center (seen theta) 0.6) "R" #:anchor 'above)
        (label (seen theta) "m" #:anchor 'right #:shift #(13 0))
        (let ([top (list 0.0 0.0 (* 1.2 r))])
          (polyline (most-of (space-ring top (list (* 0.2 r) 0.0 0.0) (list 0.0 (* 0.2 r) 0.0)))
                    #:width 1.5 #:color (caddr accents) #:arrows 'end))
        (label (in-view 0.0 0.0 (* 1.2 r)) "ω" #:anchor 'right #:shift #(16 0)
               #:color (caddr accents))))

;; Most of a circle, so that its arrow is seen.
(define (most-of points) (for/list ([p (in-list points)] [k (in-range 40)]) p))

;; On the curve, a function from the coordinate to points, drawn between two values of it.
;; With two coordinates the bead is where they say, and may leave the track.
(define (draw-bead-on-track curve from to #:width [width 360])
  (define who 'draw-bead-on-track)
  (unless (and (procedure? curve) (accepts? curve 1))
    (raise-other-function who "a function from a number to points, as track" curve))
  (define-values (a b) (values (check-number who "the start" from) (check-number who "the end" to)))
  (define (at s) (point-of who (lambda () (format "the track at ~a" s)) (curve s)))
  (define track (for/list ([k (in-range 201)]) (at (+ a (* (- b a) (/ k 200.0))))))
  (define-values (low-x high-x) (values (apply min (map at-x track)) (apply max (map at-x track))))
  (define-values (low-y high-y) (values (apply min (map at-y track)) (apply max (map at-y track))))
  (define wide (max (- high-x low-x) (- high-y low-y) 1e-9))
  (define margin (* 0.12 wide))
  (define (bead q) (if (= (vector-length q) 1) (at (vector-ref q 0)) q))
  (mechanism
   `(draw-bead-on-track ,(procedure-datum curve) ,from ,to)
   #:bounds (list (- low-x margin) (+ high-x margin) (- low-y margin) (+ high-y margin))
   #:width width #:coordinates '(1 2) #:sample (list (+ a (* 0.2 (- b a)))) #:axes '("x" "y")
   #:trail (lambda (t q) (list (bead q)))
   #:marks (lambda (t q) (list (label (bead q) "m" #:anchor 'right #:shift #(8 8))))
   (lambda (t q)
     (list (polyline track #:width 3 #:color faint) (bob (bead q) (* 0.03 wide))))))
