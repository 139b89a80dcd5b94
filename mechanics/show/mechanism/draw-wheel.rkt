#lang racket/base
;; Wheels: one that rolls down an incline, seen from the side, and a coin on a table.

(require "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane.rkt" "../animation/projection.rkt" "../animation/shapes.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt"
         "../plot/coordinate.rkt")

(provide draw-wheel draw-coin)

;; x down the incline, and the angle of turning; or x alone, if the wheel does not slip.
(define (draw-wheel #:radius [radius 1] #:slope [slope 0] #:range [range 10] #:width [width 420])
  (define who 'draw-wheel)
  (define r (check-length who "the radius" radius))
  (define long (check-length who "the range" range))
  (define alpha (check-number who "the slope" slope))
  (unless (< (abs alpha) :pi/2) (complain-of-argument who "a slope between -π/2 and π/2" slope))
  (define (foot s) (turned s (- alpha)))
  (define up-from-ground (crosswise (turned r (- alpha))))
  (define (hub q) (add (foot (vector-ref q 0)) up-from-ground))
  (define (turn q) (if (= (vector-length q) 2) (vector-ref q 1) (/ (vector-ref q 0) r)))
  (define (rim-point q angle) (add (hub q) (turned r (- angle (turn q)))))
  (define end (foot long))
  (mechanism
   `(draw-wheel #:radius ,radius #:slope ,slope #:range ,range)
   #:bounds (list (* -1.5 r) (+ (at-x end) (* 1.5 r))
                  (- (min 0.0 (at-y end)) (* 0.7 r)) (+ (max 0.0 (at-y end)) (* 2.4 r)))
   #:width width #:coordinates '(1 2) #:sample (list (* 0.35 long)) #:axes '("x" "φ")
   #:trail (lambda (t q) (list (rim-point q :pi/2)))
   #:marks (lambda (t q) (wheel-marks (hub q) (foot (vector-ref q 0)) end (turn q) r alpha))
   (lambda (t q)
     (list (wall end (foot (* -1.5 r)) #:depth (* 0.3 r))
           (disc (hub q) r #:width 3)
           (for/list ([k (in-range 6)])
             (polyline (list (hub q) (rim-point q (+ :pi/2 (/ (* pi k) 3))))
                       #:width 1 #:color faint))
           (bob (rim-point q :pi/2) (* 0.1 r)) (pivot (hub q) (* 0.1 r))))))

(define (wheel-marks hub foot end turn r alpha)
  (list (length-mark hub (add hub (turned r (+ alpha pi))) "R")
        (angle-mark hub :pi/2 (- :pi/2 (- turn (* 2.0 pi (floor (/ turn (* 2.0 pi))))))
                    (* 0.5 r) "φ")
        (length-mark (vector 0.0 0.0) foot "x" #:offset (* -0.45 r))
        (if (zero? alpha)
            '()
            (let ([corner (vector 0.0 (at-y end))])
              (list (polyline (list end corner) #:width 1 #:style 'long-dash #:color faint)
                    (angle-mark end pi (- pi alpha) (* 2.0 r) "α"))))))

;; x and y of where it touches the table, φ its heading, θ its tilt from the table, ψ the
;; angle through which it has rolled.
(define (draw-coin #:radius [radius 1] #:range [range 3] #:width [width 360])
  (define who 'draw-coin)
  (define r (check-length who "the radius" radius))
  (define far (check-length who "the range" range))
  (define (foot q) (in-view (vector-ref q 0) (vector-ref q 1) 0.0))
  (mechanism
   `(draw-coin #:radius ,radius #:range ,range)
   #:bounds (list (* -1.5 far) (* 1.5 far) (* -0.8 far) (+ (* 0.8 far) (* 1.2 r)))
   #:width width #:coordinates '(5) #:sample (list 0.0 0.0 0.5 1.1 0.8)
   #:axes '("x" "y" "φ" "θ" "ψ")
   #:trail (lambda (t q) (list (foot q)))
   #:marks (lambda (t q) (coin-marks q (foot q) r))
   (lambda (t q)
     (define-values (center along steep) (coin-frame q r))
     (define psi (vector-ref q 4))
     (define-values (c s) (values (* -1.0 (sin psi)) (* -1.0 (cos psi))))
     (define mark
       (apply in-view
              (for/list ([x center] [u along] [v steep]) (+ x (* 0.75 (+ (* c u) (* s v)))))))
     (list (polyline (for/list ([p '((-1 -1) (1 -1) (1 1) (-1 1))])
                       (in-view (* far (car p)) (* far (cadr p)) 0.0))
                     #:closed? #t #:width 1 #:color faint)
           (polyline (space-ring center along steep) #:closed? #t #:fill '(230 200 110) #:width 2)
           (bob mark (* 0.07 r))))))

(define (coin-marks q foot r)
  (define-values (center along steep) (coin-frame q r))
  (define phi (vector-ref q 2))
  (define heading
    (in-view (+ (vector-ref q 0) (* 2.0 r (cos phi))) (+ (vector-ref q 1) (* 2.0 r (sin phi))) 0.0))
  (list (space-axes (* 1.4 r))
        (vector-arrow foot heading #:label "φ")
        (label foot "(x, y)" #:anchor 'below)
        (label (apply in-view (map + center steep)) "θ" #:anchor 'above)))

;; Center, and the two vectors from there to the rim: the one it heads in, the steepest.
(define (coin-frame q r)
  (define-values (x y phi theta)
    (values (vector-ref q 0) (vector-ref q 1) (vector-ref q 2) (vector-ref q 3)))
  (define steep
    (list (* -1.0 r (cos theta) (sin phi)) (* r (cos theta) (cos phi)) (* r (sin theta))))
  (values (map + (list x y 0.0) steep)
          (list (* r (cos phi)) (* r (sin phi)) 0.0)
          steep))
