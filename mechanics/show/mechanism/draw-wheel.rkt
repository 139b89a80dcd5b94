#lang racket/base
;; Wheels: one that rolls down an incline, seen from the side, and a coin on a table.

(require "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane-vector.rkt" "../animation/projection.rkt"
         "../animation/shapes.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt"
         "../plot/plotted-number.rkt")

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
  (define end (foot long))
  (mechanism
   `(draw-wheel #:radius ,radius #:slope ,slope #:range ,range)
   #:bounds (list (* -1.5 r) (+ (at-x end) (* 1.5 r))
                  (- (min 0.0 (at-y end)) (* 0.7 r)) (+ (max 0.0 (at-y end)) (* 2.4 r)))
   #:width width #:coordinates '(1 2) #:sample (list (* 0.35 long)) #:axes '("x" "φ")
   (lambda (t q)
     (define x (vector-ref q 0))
     (define turn (if (= (vector-length q) 2) (vector-ref q 1) (/ x r)))
     (define hub (add (foot x) up-from-ground))
     (define (rim-point angle) (add hub (turned r (- angle turn))))
     (define mark (rim-point :pi/2))
     (drawn #:trail (list mark)
            #:marks (wheel-marks hub (foot x) end turn r alpha)
            #:shapes (list (wall end (foot (* -1.5 r)) #:depth (* 0.3 r))
                           (disc hub r #:width 3)
                           (for/list ([k (in-range 6)])
                             (thin hub (rim-point (+ :pi/2 (/ (* pi k) 3)))))
                           (bob mark (* 0.1 r)) (pivot hub (* 0.1 r)))))))

(define (wheel-marks hub foot end turn r alpha)
  (list (length-mark hub (add hub (turned r (+ alpha pi))) "R")
        (angle-mark hub :pi/2 (- :pi/2 (- turn (* 2.0 pi (floor (/ turn (* 2.0 pi))))))
                    (* 0.5 r) "φ")
        (length-mark origin foot "x" #:offset (* -0.45 r))
        (if (zero? alpha)
            '()
            (let ([corner (vector 0.0 (at-y end))])
              (list (dashed end corner)
                    (angle-mark end pi (- pi alpha) (* 2.0 r) "α"))))))

;; x and y of where it touches the table, φ its heading, θ its tilt from the table, ψ the
;; angle through which it has rolled.
(define (draw-coin #:radius [radius 1] #:range [range 3] #:width [width 360])
  (define who 'draw-coin)
  (define r (check-length who "the radius" radius))
  (define far (check-length who "the range" range))
  (mechanism
   `(draw-coin #:radius ,radius #:range ,range)
   #:bounds (list (* -1.5 far) (* 1.5 far) (* -0.8 far) (+ (* 0.8 far) (* 1.2 r)))
   #:width width #:coordinates '(5) #:sample (list 0.0 0.0 0.5 1.1 0.8)
   #:axes '("x" "y" "φ" "θ" "ψ")
   (lambda (t q)
     (define-values (x y phi theta psi) (vector->values q))
     (define foot (list x y 0.0))
     (define-values (along steep) (coin-radii phi theta r))
     (drawn #:trail (list (in-view foot))
            #:marks (coin-marks foot phi (map + foot steep steep) r)
            #:shapes (coin-shapes (map + foot steep) along steep psi far r)))))

;; The two vectors from the center to the rim: in the direction of the heading, and the steepest.
(define (coin-radii phi theta r)
  (values (list (* r (cos phi)) (* r (sin phi)) 0.0)
          (list (* -1.0 r (cos theta) (sin phi)) (* r (cos theta) (cos phi)) (* r (sin theta)))))

(define (coin-shapes center along steep psi far r)
  (define-values (c s) (values (* -1.0 (sin psi)) (* -1.0 (cos psi))))
  (define mark (for/list ([x center] [u along] [v steep]) (+ x (* 0.75 (+ (* c u) (* s v))))))
  (list (polyline (for/list ([p '((-1 -1 0.0) (1 -1 0.0) (1 1 0.0) (-1 1 0.0))])
                    (in-view (scaled far p)))
                  #:closed? #t #:width 1 #:color faint)
        (polyline (space-ring center along steep) #:closed? #t #:fill '(230 200 110) #:width 2)
        (bob (in-view mark) (* 0.07 r))))

(define (coin-marks foot phi top r)
  (define ahead (list (* 2.0 r (cos phi)) (* 2.0 r (sin phi)) 0.0))
  (list (space-axes (* 1.4 r))
        (vector-arrow (in-view foot) (in-view (map + foot ahead)) #:label "φ")
        (label (in-view foot) "(x, y)" #:anchor 'below)
        (label (in-view top) "θ" #:anchor 'above)))
