#lang racket/base
;; Bodies that turn in space, by Euler's angles θ, φ, ψ: a top on its point (SICM 2.10), and
;; a brick (SICM 2.9).

(require (only-in racket/list last)
         "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane-vector.rkt" "../animation/projection.rkt"
         "../animation/shapes.rkt")

(provide draw-top draw-brick)

;; The axes of the body, lists of three, for M = Rz(φ) Rx(θ) Rz(ψ).
(define (body-axes q)
  (define-values (theta phi psi) (vector->values q))
  (define-values (ct st cp sp cs ss)
    (values (cos theta) (sin theta) (cos phi) (sin phi) (cos psi) (sin psi)))
  (values (list (- (* cp cs) (* sp ct ss)) (+ (* sp cs) (* cp ct ss)) (* st ss))
          (list (- (+ (* cp ss) (* sp ct cs))) (- (* cp ct cs) (* sp ss)) (* st cs))
          (list (* sp st) (* -1.0 cp st) ct)))

;; The point at a multiple of a vector of space, as it is seen.
(define (at-multiple a v) (in-view (scaled a v)))

(define (draw-top #:length [length 1] #:radius [radius 0.4] #:width [width 300])
  (define who 'draw-top)
  (define l (check-length who "the length" length))
  (define r (check-length who "the radius" radius))
  (define reach (max l r))
  (mechanism
   `(draw-top #:length ,length #:radius ,radius)
   #:bounds (scaled reach '(-1.2 1.2 -0.8 1.5))
   #:width width #:coordinates '(3) #:sample '(0.5 2.2 0.6) #:axes '("θ" "φ" "ψ")
   (lambda (t q)
     (define-values (a b axis) (body-axes q))
     (define end (at-multiple (* 1.25 l) axis))
     (drawn #:trail (list end)
            #:marks (top-marks q axis end l)
            #:shapes (top-shapes a b axis end l r)))))

(define (top-shapes a b axis end l r)
  (define center (scaled (* 0.8 l) axis))
  (define rim (space-ring center (scaled r a) (scaled r b)))
  (define spoke (map + center (scaled (* 0.7 r) a)))
  (define body
    (list (cone rim (on-vertical 0.0))
          (polyline rim #:closed? #t #:fill (car accents) #:width 2)
          (disc (in-view spoke) (* 0.1 r) #:fill "white" #:width 1)))
  (define stem (rod (in-view center) end))
  (list (polyline (level-ring 0.0 (* 0.5 l)) #:closed? #t #:width 1 #:color faint)
        (if (< (nearness axis) 0.0) (list stem body) (list body stem))))

;; From the point to the rim: the outline of all lines between them.
(define (cone rim point)
  (define (side p) (atan (at-x (minus p point)) (at-y (minus p point))))
  (define sorted (sort rim < #:key side))
  (polyline (list (car sorted) point (last sorted)) #:fill '(150 180 215) #:width 1.5))

(define (top-marks q axis end l)
  (define-values (theta phi psi) (vector->values q))
  (define arc
    (for/list ([k (in-range 13)])
      (define-values (a b axis) (body-axes (vector (* theta (/ k 12.0)) phi 0.0)))
      (at-multiple (* 0.45 l) axis)))
  (list (space-axes (* 1.4 l))
        (polyline arc #:color (cadr accents) #:width 1.5 #:arrows 'end)
        (label (list-ref arc 6) "θ" #:anchor 'above #:color (cadr accents))
        (label end "axis" #:anchor 'right #:italic? #f #:size 12)
        (label (at-multiple (* 0.8 l) axis) "ψ" #:anchor 'right #:shift #(26 10))
        (label (on-vertical 0.0) "φ" #:anchor 'below #:shift #(0 -8))))

;; A brick with edges a, b, c along its axes, about its center.
(define (draw-brick #:edges [edges '(1 2 3)] #:width [width 300])
  (define who 'draw-brick)
  (define (three? edges) (= (length edges) 3))
  (define half
    (scaled 0.5 (check-lengths who "a list of three lengths" "an edge" three? edges)))
  (define reach (sqrt (apply + (map (lambda (h) (* h h)) half))))
  (mechanism
   `(draw-brick #:edges ,(cons 'list edges))
   #:bounds (scaled reach '(-1.2 1.2 -1.2 1.2))
   #:width width #:coordinates '(3) #:sample '(0.25 0.0 -1.7) #:axes '("θ" "φ" "ψ")
   (lambda (t q)
     (define-values (a b c) (body-axes q))
     (define axes (list a b c))
     (drawn #:trail (list (at-multiple (caddr half) c))
            #:marks (for/list ([axis (in-list axes)] [h (in-list half)] [name '("a" "b" "c")])
                      (vector-arrow (at-multiple h axis) (at-multiple (+ h (* 0.35 reach)) axis)
                                    #:label name))
            #:shapes (faces (map scaled half axes))))))

;; The faces towards the eye; u, v, w : from the center to the middle of faces
(define (faces edges)
  (for*/list ([k (in-range 3)] [sign (in-list '(1.0 -1.0))]
              [out (in-value (scaled sign (list-ref edges k)))]
              #:when (> (nearness out) 0.0))
    (define u (list-ref edges (modulo (+ k 1) 3)))
    (define v (list-ref edges (modulo (+ k 2) 3)))
    (polyline (for/list ([p '((1 1) (-1 1) (-1 -1) (1 -1))])
                (in-view (map + out (scaled (car p) u) (scaled (cadr p) v))))
              #:closed? #t #:width 1.5
              #:fill (list-ref '((70 130 200) (215 110 60) (70 160 110)) k))))
