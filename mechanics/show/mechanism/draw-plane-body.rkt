#lang racket/base
;; Bodies that move in a plane and turn in it: a ladder at a wall, a sleigh on a blade.

(require "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane.rkt" "../animation/shapes.rkt"
         "../../numeric/constants.rkt")

(provide draw-ladder draw-sleigh)

;; The angle with the floor, both ends at wall and floor; or the center's x and y, and the
;; angle.
(define (draw-ladder #:length [length 1] #:width [width 300])
  (define l (check-length 'draw-ladder "the length" length))
  (define (ends q)
    (define three? (= (vector-length q) 3))
    (define half (turned (/ l 2.0) (- pi (vector-ref q (if three? 2 0)))))
    (define center
      (if three?
          (vector (vector-ref q 0) (vector-ref q 1))
          (vector (- (at-x half)) (at-y half))))
    (values (add center half) center (minus center half)))
  (mechanism
   `(draw-ladder #:length ,length)
   #:bounds (for/list ([x '(-0.2 1.7 -0.2 1.2)]) (* l x))
   #:width width #:coordinates '(1 3) #:sample '(0.95) #:axes '("θ")
   #:trail (lambda (t q) (let-values ([(top center foot) (ends q)]) (list center)))
   #:marks (lambda (t q)
             (define-values (top center foot) (ends q))
             (define along (minus top foot))
             (list (angle-mark foot pi (atan (at-y along) (at-x along)) (* 0.22 l) "θ")
                   (length-mark foot top "l" #:offset (* -0.08 l))
                   (disc center (* 0.02 l) #:fill ink)
                   (label center "m" #:anchor 'left #:shift #(-2 -8))))
   (lambda (t q)
     (define-values (top center foot) (ends q))
     (define origin (vector 0.0 0.0))
     (list (wall origin (vector 0.0 (* 1.15 l)) #:depth (* 0.06 l))
           (wall (vector (* 1.65 l) 0.0) origin #:depth (* 0.06 l))
           (rod top foot #:width 5 #:color (car accents))))))

;; x and y of the blade, and the direction of its edge; ahead : from the blade to the center
;; of mass
(define (draw-sleigh #:ahead [ahead 0.3] #:range [range 3] #:width [width 320])
  (define who 'draw-sleigh)
  (define a (check-length who "the distance of the center of mass" ahead))
  (define far (check-length who "the range" range))
  (define (blade q) (vector (vector-ref q 0) (vector-ref q 1)))
  (mechanism
   `(draw-sleigh #:ahead ,ahead #:range ,range)
   #:bounds (list (- far) far (- far) far)
   #:width width #:coordinates '(3) #:sample '(0.0 0.0 0.6) #:axes '("x" "y" "θ")
   #:trail (lambda (t q) (list (blade q)))
   #:marks (lambda (t q)
             (define b (blade q))
             (define angle (vector-ref q 2))
             (list (polyline (list b (add b (vector (* 3.0 a) 0.0))) #:width 1 #:style 'long-dash
                             #:color faint)
                   (angle-mark b 0.0 angle (* 2.2 a) "θ")
                   (length-mark b (add b (turned a angle)) "a" #:offset a)
                   (label b "(x, y)" #:anchor 'below #:shift #(0 -14))))
   (lambda (t q)
     (define b (blade q))
     (define forward (turned a (vector-ref q 2)))
     (list (block (add b (times 0.8 forward)) (* 4.0 a) (* 2.0 a) #:angle (vector-ref q 2)
                  #:color '(200 215 235))
           (polyline (list (minus b (times 0.7 forward)) (add b (times 0.7 forward))) #:width 4)
           (disc (add b forward) (* 0.15 a) #:fill (cadr accents) #:width 1)))))
