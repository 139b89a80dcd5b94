#lang racket/base
;; Weights on strings over pulleys: Atwood's machine, and one that hangs from another
;; (SICM 1.10).

(require "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane-vector.rkt" "../animation/shapes.rkt"
         "../../numeric/constants.rkt")

(provide draw-Atwood-machine)

;; Depths below the axis of the upper pulley: of one weight, the other following from the
;; length of the string; of both; or of a weight, the pulley that it balances, and the two
;; weights on that.
(define (draw-Atwood-machine #:length [cord 3] #:masses [masses '(1 2)] #:width [width 240])
  (define who 'draw-Atwood-machine)
  (define l (check-length who "the length" cord))
  (define (two-or-three? ms) (memv (length ms) '(2 3)))
  (define ms (check-lengths who "a list of two or three masses" "a mass" two-or-three? masses))
  (define r (* 0.11 l))
  (define greatest (apply max ms))
  (define sizes (for/list ([m (in-list ms)]) (* r (sqrt (/ m greatest)) 1.1)))
  (define three? (= (length ms) 3))
  (mechanism
   `(draw-Atwood-machine #:length ,cord #:masses ,(cons 'list masses))
   #:bounds (list (* -0.4 l) (* 0.5 l) (* (if three? -1.5 -1.15) l) (* 0.25 l))
   #:width width #:coordinates (if three? '(4) '(1 2))
   #:sample (for/list ([x (if three? '(0.45 0.55 1.0 1.25) '(0.4))]) (* l x))
   #:axes (if three? '("x_1" "y" "x_2" "x_3") '("x_1" "x_2"))
   (lambda (t q)
     (define x (vector-ref q 0))
     (define depths (if (= (vector-length q) 1) (list x (- l x)) (vector->list q)))
     (define places (weight-places depths r))
     (define top (vector 0.0 (* 1.8 r)))
     (drawn #:trail places
            #:marks (machine-marks places sizes r)
            #:shapes (list (mount top (* 1.6 r) (* 0.5 r))
                           (rod top origin #:width 2)
                           (strings depths places r)
                           (for/list ([p (in-list places)] [size (in-list sizes)]
                                      [color (in-cycle accents)])
                             (block p (* 1.6 size) (* 1.6 size) #:color color)))))))

;; The lower pulley is half as large, so that weights pass each other.
(define (weight-places depths r)
  (define (down x depth) (vector x (- depth)))
  (if (null? (cddr depths))
      (list (down (- r) (car depths)) (down r (cadr depths)))
      (list (down (- r) (car depths)) (down (* 0.3 r) (caddr depths))
            (down (* 1.7 r) (cadddr depths)))))

(define (strings depths places r)
  (define three? (pair? (cddr depths)))
  (define (over center radius left right)
    (list (polyline (append (list left) (arc center radius pi 0.0) (list right)) #:width 1.5)
          (disc center radius #:fill #f #:color faint #:width 2)
          (pivot center (* 0.15 r))))
  (define lower (vector r (- (cadr depths))))
  (list (over origin r (car places) (if three? lower (cadr places)))
        (if three? (over lower (* 0.7 r) (cadr places) (caddr places)) '())))

(define (machine-marks places sizes r)
  (for/list ([p (in-list places)] [size (in-list sizes)] [k (in-naturals 1)])
    (define side (if (= k 1) -1.0 1.0))
    (define x (+ (at-x p) (* side (+ size (* 0.6 r)))))
    (list (label (add p (vector 0.0 (* -0.8 size))) (format "m_~a" k) #:anchor 'below)
          (if (= k 2) '()
              (list (thin (vector x 0.0) (vector x (at-y p)) #:arrows 'end)
                    (label (vector x (/ (at-y p) 2)) (format "x_~a" k)
                           #:anchor (if (= k 1) 'left 'right)))))))
