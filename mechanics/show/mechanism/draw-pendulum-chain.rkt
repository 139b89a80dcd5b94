#lang racket/base
;; Pendulums that hang from each other, or from a cart: SICM 1.7, exercise 1.44.

(require (only-in racket/list drop-right)
         "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane-vector.rkt" "../animation/shapes.rkt"
         "../../numeric/constants.rkt")

(provide draw-pendulum-chain draw-cart-pendulum)

;; Each angle is from the vertical.
(define (draw-pendulum-chain #:lengths [lengths '(1 1)] #:width [width 300])
  (define who 'draw-pendulum-chain)
  (define ls (check-lengths who "a list of lengths" "a length" pair? lengths))
  (define reach (apply + ls))
  (define n (length ls))
  (mechanism
   `(draw-pendulum-chain #:lengths ,(cons 'list lengths))
   #:bounds (scaled reach '(-1.15 1.15 -1.15 1.15))
   #:width width #:coordinates (list n)
   #:sample (for/list ([k (in-range n)]) (if (even? k) 0.45 0.9))
   #:axes (numbered-names "θ" n)
   (lambda (t q)
     (define-values (last-bob points)
       (for/fold ([p origin] [points (list origin)] #:result (values p (reverse points)))
                 ([l (in-list ls)] [angle (in-vector q)])
         (define b (below p l angle))
         (values b (cons b points))))
     (drawn #:trail (list last-bob)
            #:marks (chain-marks points q ls)
            #:shapes (list (mount origin (* 0.2 reach) (* 0.06 reach))
                           (map rod (drop-right points 1) (cdr points))
                           (pivot origin (* 0.02 reach))
                           (for/list ([b (in-list (cdr points))] [color (in-cycle accents)])
                             (bob b (* 0.05 reach) #:color color)))))))

(define (chain-marks points q ls)
  (for/list ([p (in-list points)] [b (in-list (cdr points))] [l (in-list ls)]
             [angle (in-vector q)] [k (in-naturals 1)])
    (define (name letter) (numbered letter k (length ls)))
    (list (plumb p l)
          (swing-mark p (- angle :pi/2) (* 0.45 l) (name "θ"))
          (length-mark p b (name "l"))
          (name-beside b (name "m")))))

;; The vertical from which an angle is measured.
(define (plumb p l) (dashed p (below p (* 0.8 l) 0.0)))

;; x of the cart, and the angle of the pendulum that hangs from it.
(define (draw-cart-pendulum #:length [length 1] #:range [range 2] #:width [width 360])
  (define who 'draw-cart-pendulum)
  (define l (check-length who "the length" length))
  (define r (check-length who "the range" range))
  (define far (+ r (* 0.4 l)))
  (mechanism
   `(draw-cart-pendulum #:length ,length #:range ,range)
   #:bounds (list (- far) far (* -1.25 l) (* 1.25 l))
   #:width width #:coordinates '(2) #:sample '(0.5 0.6) #:axes '("x" "θ")
   (lambda (t q)
     (define-values (x angle) (vector->values q))
     (define p (vector x 0.0))
     (define b (below p l angle))
     (drawn #:trail (list b)
            #:marks (cart-marks p b angle l)
            #:shapes (list (polyline (list (vector (- far) (* -0.2 l)) (vector far (* -0.2 l)))
                                     #:color faint)
                           (block p (* 0.5 l) (* 0.22 l) #:color faint)
                           (for/list ([side '(-0.15 0.15)])
                             (disc (add p (vector (* side l) (* -0.155 l))) (* 0.045 l)
                                   #:fill "white"))
                           (swinging p b l))))))

(define (cart-marks p b angle l)
  (define-values (x y) (values (at-x p) (* 0.75 l)))
  (list (plumb p l)
        (swing-mark p (- angle :pi/2) (* 0.55 l) "θ")
        (length-mark p b "l")
        (name-beside b "m")
        (label (add p (vector 0.0 (* 0.15 l))) "M" #:anchor 'above)
        (thin (vector 0.0 y) (vector x y) #:arrows 'end)
        (label (vector (* 0.5 x) y) "x" #:anchor 'above)))
