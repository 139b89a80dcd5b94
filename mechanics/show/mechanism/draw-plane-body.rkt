#lang racket/base
;; Bodies that move in a plane and turn in it: a ladder at a wall, a sleigh on a blade.

(require "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane-vector.rkt" "../animation/shapes.rkt"
         "../../numeric/constants.rkt")

(provide draw-ladder draw-sleigh)

;; The angle with the floor, both ends at wall and floor; or the center's x and y, and the
;; angle.
(define (draw-ladder #:length [length 1] #:width [width 300])
  (define l (check-length 'draw-ladder "the length" length))
  (mechanism
   `(draw-ladder #:length ,length)
   #:bounds (scaled l '(-0.2 1.7 -0.2 1.2))
   #:width width #:coordinates '(1 3) #:sample '(0.95) #:axes '("θ")
   (lambda (t q)
     (define three? (= (vector-length q) 3))
     (define half (turned (/ l 2.0) (- pi (vector-ref q (if three? 2 0)))))
     (define center (if three? (vector (at-x q) (at-y q)) (vector (- (at-x half)) (at-y half))))
     (define-values (top foot) (values (add center half) (minus center half)))
     (drawn #:trail (list center)
            #:marks (list (angle-mark foot pi (direction (minus top foot)) (* 0.22 l) "θ")
                          (length-mark foot top "l" #:offset (* -0.08 l))
                          (disc center (* 0.02 l) #:fill ink)
                          (label center "m" #:anchor 'left #:shift #(-2 -8)))
            #:shapes (list (wall origin (vector 0.0 (* 1.15 l)) #:depth (* 0.06 l))
                           (wall (vector (* 1.65 l) 0.0) origin #:depth (* 0.06 l))
                           (rod top foot #:width 5 #:color (car accents)))))))

;; x and y of the blade, and the direction of its edge; ahead : from the blade to the center
;; of mass
(define (draw-sleigh #:ahead [ahead 0.3] #:range [range 3] #:width [width 320])
  (define who 'draw-sleigh)
  (define a (check-length who "the distance of the center of mass" ahead))
  (define far (check-length who "the range" range))
  (mechanism
   `(draw-sleigh #:ahead ,ahead #:range ,range)
   #:bounds (list (- far) far (- far) far)
   #:width width #:coordinates '(3) #:sample '(0.0 0.0 0.6) #:axes '("x" "y" "θ")
   (lambda (t q)
     (define-values (x y angle) (vector->values q))
     (define blade (vector x y))
     (define forward (turned a angle))
     (define edge (times 0.7 forward))
     (define mass (add blade forward))
     (drawn #:trail (list blade)
            #:marks (list (dashed blade (add blade (vector (* 3.0 a) 0.0)))
                          (angle-mark blade 0.0 angle (* 2.2 a) "θ")
                          (length-mark blade mass "a" #:offset a)
                          (label blade "(x, y)" #:anchor 'below #:shift #(0 -14)))
            #:shapes (list (block (add blade (times 0.8 forward)) (* 4.0 a) (* 2.0 a)
                                  #:angle angle #:color '(200 215 235))
                           (polyline (list (minus blade edge) (add blade edge)) #:width 4)
                           (disc mass (* 0.15 a) #:fill (cadr accents) #:width 1))))))
