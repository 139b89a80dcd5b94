#lang racket/base
;; Bodies that attract each other: one about a center at rest, or any number of them.

(require "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane-vector.rkt" "../animation/shapes.rkt")

(provide draw-orbit draw-bodies)

;; x and y from the center, or r and φ with #:polar? #t; range : how far one sees
(define (draw-orbit #:range [range 2] #:polar? [polar? #f] #:width [width 320])
  (define far (check-length 'draw-orbit "the range" range))
  (mechanism
   `(draw-orbit #:range ,range ,@(if polar? '(#:polar? #t) '()))
   #:bounds (list (- far) far (- far) far)
   #:width width #:coordinates '(2)
   #:sample (if polar? (list (* 0.75 far) 0.6) (list (* 0.6 far) (* 0.42 far)))
   #:axes (if polar? '("r" "φ") '("x" "y"))
   (lambda (t q)
     (define p (if polar? (turned (vector-ref q 0) (vector-ref q 1)) q))
     (drawn #:trail (list p)
            #:marks (list (dashed origin (vector (* 0.9 far) 0.0))
                          (thin origin p)
                          (label (between origin p 0.5) "r" #:anchor 'above #:shift #(-6 0))
                          (angle-mark origin 0.0 (direction p) (* 0.35 far) "φ")
                          (name-beside p "m" 12)
                          (label origin "M" #:anchor 'below #:shift #(0 -14)))
            #:shapes (list (disc origin (* 0.05 far) #:fill '(240 180 40) #:width 1)
                           (bob p (* 0.03 far)))))))

;; x and y of each body in turn
(define (draw-bodies #:masses [masses '(1 1)] #:range [range 2] #:width [width 320])
  (define who 'draw-bodies)
  (define ms (check-lengths who "a list of masses" "a mass" pair? masses))
  (define far (check-length who "the range" range))
  (define n (length ms))
  (define greatest (apply max ms))
  (define (size m) (* 0.06 far (max 0.3 (expt (/ m greatest) 1/3))))
  (mechanism
   `(draw-bodies #:masses ,(cons 'list masses) #:range ,range)
   #:bounds (list (- far) far (- far) far)
   #:width width #:coordinates (list (* 2 n))
   #:sample (for*/list ([k (in-range n)]
                        [p (in-value (turned (* far (+ 0.35 (/ (* 0.3 k) n)))
                                             (+ 0.4 (* 6.28 (/ k n)))))]
                        [x (in-vector p)])
              x)
   #:axes (for*/list ([k (in-range 1 (+ n 1))] [axis (in-list '("x" "y"))])
            (format "~a_~a" axis k))
   (lambda (t q)
     (define places
       (for/list ([k (in-range n)])
         (vector (vector-ref q (* 2 k)) (vector-ref q (+ 1 (* 2 k))))))
     (drawn #:trail places
            #:marks (body-marks places)
            #:shapes (for/list ([p (in-list places)] [m (in-list ms)] [color (in-cycle accents)])
                       (bob p (size m) #:color color))))))

(define (body-marks places)
  (list (for*/list ([p (in-list places)] [o (in-list places)] #:when (< (at-x p) (at-x o)))
          (polyline (list p o) #:width 1 #:color faint #:style 'dot))
        (for/list ([p (in-list places)] [k (in-naturals 1)])
          (name-beside p (format "m_~a" k) 14))))
