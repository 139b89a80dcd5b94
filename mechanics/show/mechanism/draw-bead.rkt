#lang racket/base
;; Beads: on a ring that turns about its vertical diameter, and on a track in a plane.

(require (only-in racket/list take)
         "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane-vector.rkt" "../animation/projection.rkt"
         "../animation/shapes.rkt"
         "../../generic/describe.rkt"
         "../../numeric/constants.rkt"
         "../plot/plotted-number.rkt")

(provide draw-bead-on-ring draw-bead-on-track)

;; θ from the bottom; the ring has turned by the angular velocity times the time.
(define (draw-bead-on-ring #:radius [radius 1] #:angular-velocity [omega 0] #:width [width 300])
  (define who 'draw-bead-on-ring)
  (define r (check-length who "the radius" radius))
  (define rate (check-number who "the angular velocity" omega))
  (mechanism
   `(draw-bead-on-ring #:radius ,radius #:angular-velocity ,omega)
   #:bounds (scaled r '(-1.3 1.3 -1.4 1.4))
   #:width width #:coordinates '(1) #:sample '(0.9) #:axes '("θ")
   (lambda (t q)
     (define theta (vector-ref q 0))
     (define turn (* rate t))
     (define (place theta)
       (list (* r (sin theta) (cos turn)) (* r (sin theta) (sin turn)) (* -1.0 r (cos theta))))
     (define bead (in-view (place theta)))
     (drawn #:trail (list bead)
            #:marks (ring-marks (lambda (angle) (in-view (place angle))) theta r)
            #:shapes (list (ring-shapes place r) (bob bead (* 0.08 r)))))))

;; place : angle from the bottom -> point of space
(define (ring-shapes place r)
  (define (axis from to)
    (polyline (list (on-vertical from) (on-vertical to)) #:color faint #:width 3))
  (define (half from)
    (for/list ([k (in-range 33)]) (in-view (place (+ from (/ (* pi k) 32))))))
  (define (middle-nearness from) (nearness (place (+ :pi/2 from))))
  (list (axis (* -1.35 r) (* -1.0 r)) (axis r (* 1.35 r))
        ;; the half away from the eye first
        (for/list ([from (in-list (sort (list 0.0 pi) < #:key middle-nearness))]
                   [width (in-list '(2 4))])
          (polyline (half from) #:width width))))

;; seen : angle from the bottom -> point
(define (ring-marks seen theta r)
  (define center (on-vertical 0.0))
  (define top (on-vertical (* 1.2 r)))
  (define arc
    (for/list ([k (in-range 17)]) (between center (seen (* theta (/ k 16.0))) 0.45)))
  (list (dashed center (seen 0.0))
        (thin center (seen theta))
        (polyline arc #:width 1.2 #:color (cadr accents) #:arrows 'end)
        (label (between center (seen (/ theta 2)) 0.6) "θ" #:color (cadr accents))
        (label (between center (seen theta) 0.6) "R" #:anchor 'above)
        (name-beside (seen theta) "m")
        ;; most of a circle, so that its arrow is seen
        (polyline (take (level-ring (* 1.2 r) (* 0.2 r)) 40)
                  #:width 1.5 #:color (caddr accents) #:arrows 'end)
        (label top "ω" #:anchor 'right #:shift #(16 0) #:color (caddr accents))))

;; On the curve, a function from the coordinate to points, drawn between two values of it.
;; With two coordinates the bead is where they say, and may leave the track.
(define (draw-bead-on-track curve from to #:width [width 360])
  (define who 'draw-bead-on-track)
  (check-function who curve 1 "a function from a number to points, as track")
  (define-values (a b) (values (check-number who "the start" from) (check-number who "the end" to)))
  (define (at s) (point-of who (lambda () (format "the track at ~a" s)) (curve s)))
  (define track (for/list ([k (in-range 201)]) (at (+ a (* (- b a) (/ k 200.0))))))
  (define (bound choose part) (apply choose (map part track)))
  (define-values (low-x high-x low-y high-y)
    (values (bound min at-x) (bound max at-x) (bound min at-y) (bound max at-y)))
  (define wide (max (- high-x low-x) (- high-y low-y) 1e-9))
  (define margin (* 0.12 wide))
  (mechanism
   `(draw-bead-on-track ,(procedure-datum curve) ,from ,to)
   #:bounds (list (- low-x margin) (+ high-x margin) (- low-y margin) (+ high-y margin))
   #:width width #:coordinates '(1 2) #:sample (list (+ a (* 0.2 (- b a)))) #:axes '("x" "y")
   (lambda (t q)
     (define bead (if (= (vector-length q) 1) (at (vector-ref q 0)) q))
     (drawn #:trail (list bead)
            #:marks (list (label bead "m" #:anchor 'right #:shift #(8 8)))
            #:shapes (list (polyline track #:width 3 #:color faint) (bob bead (* 0.03 wide)))))))
