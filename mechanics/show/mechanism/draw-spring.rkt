#lang racket/base
;; Masses on springs.

(require "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane.rkt" "../animation/shapes.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt")

(provide draw-oscillator draw-spring-pendulum)

;; Masses in a row between springs of that length at rest; each coordinate is from its mass's
;; place of rest.  One mass has a spring on its left; more have one at either end as well.
(define (draw-oscillator #:masses [n 1] #:length [length 1] #:width [width 360])
  (define who 'draw-oscillator)
  (unless (and (exact-positive-integer? n) (<= n 20))
    (complain-of-argument who "a number of masses from 1 to 20" n))
  (define l (check-length who "the length" length))
  (define end (* l (if (= n 1) 2.0 (+ n 1))))
  (define side (* 0.24 l))
  (define (rest k) (* l (+ k 1.0)))
  (define (places q) (for/list ([x (in-vector q)] [k (in-naturals)]) (vector (+ (rest k) x) 0.0)))
  (mechanism
   `(draw-oscillator #:masses ,n #:length ,length)
   #:bounds (list (* -0.2 l) (+ end (* 0.2 l)) (* -0.5 l) (* 0.5 l))
   #:width width #:coordinates (list n)
   #:sample (for/list ([k (in-range n)]) (if (even? k) (* 0.3 l) (* -0.15 l)))
   #:axes (if (= n 1) '("x") (for/list ([k (in-range n)]) (format "x_~a" (+ k 1))))
   #:trail (lambda (t q) (places q))
   #:marks (lambda (t q) (oscillator-marks n (places q) rest side))
   (lambda (t q) (oscillator-shapes (places q) end side l))))

(define (oscillator-shapes centers end side l)
  (define one? (null? (cdr centers)))
  (define half (vector (/ side 2.0) 0.0))
  (define lefts (cons (vector 0.0 0.0) (map (lambda (c) (add c half)) centers)))
  (define rights
    (append (map (lambda (c) (minus c half)) centers)
            (if one? '() (list (vector end 0.0)))))
  (list (wall (vector 0.0 (* -0.35 l)) (vector 0.0 (* 0.35 l)) #:depth (* 0.1 l))
        (if one?
            '()
            (wall (vector end (* 0.35 l)) (vector end (* -0.35 l)) #:depth (* 0.1 l)))
        (polyline (list (vector 0.0 (* -0.55 side)) (vector end (* -0.55 side)))
                  #:color faint #:width 1)
        (for/list ([a (in-list lefts)] [b (in-list rights)]) (spring a b #:width (* 0.14 l)))
        (for/list ([c (in-list centers)] [color (in-cycle accents)])
          (block c side side #:color color))))

(define (oscillator-marks n centers rest side)
  (for/list ([c (in-list centers)] [k (in-naturals)])
    (define (name letter) (if (= n 1) letter (format "~a_~a" letter (+ k 1))))
    (define zero (vector (rest k) (* 1.1 side)))
    (list (polyline (list (vector (rest k) (* -0.55 side)) (add zero (vector 0.0 (* 0.3 side))))
                    #:width 1 #:style 'long-dash #:color faint)
          (polyline (list zero (vector (at-x c) (* 1.1 side))) #:arrows 'end
                    #:color (cadr accents) #:width 1.5)
          (label (between zero (vector (at-x c) (* 1.1 side)) 0.5) (name "x") #:anchor 'above
                 #:color (cadr accents))
          (label (add c (vector 0.0 (* -0.6 side))) (name "m") #:anchor 'below)
          (if (= k 0)
              (label (vector (* 0.5 (- (at-x c) (/ side 2))) (* 0.35 side)) "k" #:anchor 'above)
              '()))))

;; r and θ; or x and y of the bob with #:rectangular? #t
(define (draw-spring-pendulum #:length [length 1] #:rectangular? [rectangular? #f]
                              #:width [width 300])
  (define l (check-length 'draw-spring-pendulum "the length" length))
  (define origin (vector 0.0 0.0))
  (define (bob-of q)
    (if rectangular? q (below origin (vector-ref q 0) (vector-ref q 1))))
  (mechanism
   `(draw-spring-pendulum #:length ,length ,@(if rectangular? '(#:rectangular? #t) '()))
   #:bounds (for/list ([x '(-1.7 1.7 -2.2 0.8)]) (* l x))
   #:width width #:coordinates '(2)
   #:sample (if rectangular? (list (* 0.7 l) (* -1.0 l)) (list (* 1.2 l) 0.55))
   #:axes (if rectangular? '("x" "y") '("r" "θ"))
   #:trail (lambda (t q) (list (bob-of q)))
   #:marks (lambda (t q)
             (define b (bob-of q))
             (list (polyline (list origin (below origin (* 1.2 l) 0.0)) #:width 1
                             #:style 'long-dash #:color faint)
                   (angle-mark origin (- :pi/2) (atan (at-y b) (at-x b)) (* 0.6 l) "θ")
                   (length-mark origin b "r" #:offset (* 0.25 l))
                   (label b "m" #:anchor 'right #:shift #(13 0))))
   (lambda (t q)
     (define b (bob-of q))
     (list (wall (vector (* -0.3 l) 0.0) (vector (* 0.3 l) 0.0) #:depth (* 0.09 l))
           (spring origin b #:width (* 0.16 l) #:coils 10)
           (bob b (* 0.1 l))))))
