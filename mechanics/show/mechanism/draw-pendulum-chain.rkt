#lang racket/base
;; Pendulums that hang from each other, or from a cart: SICM 1.7, exercise 1.44.

(require "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane.rkt" "../animation/shapes.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt"
         "../../numeric/constants.rkt")

(provide draw-pendulum-chain draw-cart-pendulum)

;; Each angle is from the vertical.
(define (draw-pendulum-chain #:lengths [lengths '(1 1)] #:width [width 300])
  (define who 'draw-pendulum-chain)
  (unless (and (list? lengths) (pair? lengths))
    (complain who "expected a list of lengths\n  given: ~a" (describe-with-value lengths)))
  (define ls (for/list ([l (in-list lengths)]) (check-length who "a length" l)))
  (define reach (apply + ls))
  (define n (length ls))
  ;; The pivot and the bobs.
  (define (joints q)
    (reverse
     (for/fold ([points (list (vector 0.0 0.0))]) ([l (in-list ls)] [angle (in-vector q)])
       (cons (below (car points) l angle) points))))
  (mechanism
   `(draw-pendulum-chain #:lengths ,(cons 'list lengths))
   #:bounds (for/list ([x '(-1.15 1.15 -1.15 1.15)]) (* reach x))
   #:width width #:coordinates (list n)
   #:sample (for/list ([k (in-range n)]) (if (even? k) 0.45 0.9))
   #:axes (if (= n 1) '("θ") (for/list ([k (in-range n)]) (format "θ_~a" (+ k 1))))
   #:trail (lambda (t q) (list (car (reverse (joints q)))))
   #:marks (lambda (t q) (chain-marks (joints q) q ls))
   (lambda (t q)
     (define points (joints q))
     (list (wall (vector (* -0.2 reach) 0.0) (vector (* 0.2 reach) 0.0) #:depth (* 0.06 reach))
           (for/list ([p (in-list points)] [b (in-list (cdr points))]) (rod p b))
           (pivot (car points) (* 0.02 reach))
           (for/list ([b (in-list (cdr points))] [color (in-cycle accents)])
             (bob b (* 0.05 reach) #:color color))))))

(define (chain-marks points q ls)
  (for/list ([p (in-list points)] [b (in-list (cdr points))] [l (in-list ls)]
             [angle (in-vector q)] [k (in-naturals 1)])
    (define (name letter) (if (= (length ls) 1) letter (format "~a_~a" letter k)))
    (list (plumb p l)
          (angle-mark p (- :pi/2) (- angle :pi/2) (* 0.45 l) (name "θ"))
          (length-mark p b (name "l"))
          (label b (name "m") #:anchor 'right #:shift #(13 0)))))

;; The vertical from which an angle is measured.
(define (plumb p l)
  (polyline (list p (below p (* 0.8 l) 0.0)) #:width 1 #:style 'long-dash #:color faint))

;; x of the cart, and the angle of the pendulum that hangs from it.
(define (draw-cart-pendulum #:length [length 1] #:range [range 2] #:width [width 360])
  (define who 'draw-cart-pendulum)
  (define l (check-length who "the length" length))
  (define r (check-length who "the range" range))
  (define (cart q) (vector (vector-ref q 0) 0.0))
  (define (bob-of q) (below (cart q) l (vector-ref q 1)))
  (mechanism
   `(draw-cart-pendulum #:length ,length #:range ,range)
   #:bounds (list (- (+ r (* 0.4 l))) (+ r (* 0.4 l)) (* -1.25 l) (* 1.25 l))
   #:width width #:coordinates '(2) #:sample '(0.5 0.6) #:axes '("x" "θ")
   #:trail (lambda (t q) (list (bob-of q)))
   #:marks (lambda (t q)
             (define p (cart q))
             (list (plumb p l)
                   (angle-mark p (- :pi/2) (- (vector-ref q 1) :pi/2) (* 0.55 l) "θ")
                   (length-mark p (bob-of q) "l")
                   (label (bob-of q) "m" #:anchor 'right #:shift #(13 0))
                   (label (add p (vector 0.0 (* 0.15 l))) "M" #:anchor 'above)
                   (polyline (list (vector 0.0 (* 0.75 l)) (vector (vector-ref q 0) (* 0.75 l)))
                             #:width 1 #:color faint #:arrows 'end)
                   (label (vector (* 0.5 (vector-ref q 0)) (* 0.75 l)) "x" #:anchor 'above)))
   (lambda (t q)
     (define p (cart q))
     (define floor (* -0.2 l))
     (list (polyline (list (vector (- (+ r (* 0.4 l))) floor) (vector (+ r (* 0.4 l)) floor))
                     #:color faint)
           (block p (* 0.5 l) (* 0.22 l) #:color faint)
           (for/list ([side '(-0.15 0.15)])
             (disc (add p (vector (* side l) (* -0.155 l))) (* 0.045 l) #:fill "white"))
           (rod p (bob-of q)) (pivot p (* 0.025 l)) (bob (bob-of q) (* 0.08 l))))))
