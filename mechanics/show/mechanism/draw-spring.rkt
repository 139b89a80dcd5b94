#lang racket/base
;; Masses on springs.

(require "mechanism-parts.rkt"
         "../animation/drawing.rkt" "../animation/plane-vector.rkt" "../animation/shapes.rkt"
         "../../generic/wrong-argument.rkt")

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
  (mechanism
   `(draw-oscillator #:masses ,n #:length ,length)
   #:bounds (list (* -0.2 l) (+ end (* 0.2 l)) (* -0.5 l) (* 0.5 l))
   #:width width #:coordinates (list n)
   #:sample (for/list ([k (in-range n)]) (if (even? k) (* 0.3 l) (* -0.15 l)))
   #:axes (numbered-names "x" n)
   (lambda (t q)
     (define places
       (for/list ([x (in-vector q)] [k (in-naturals)]) (vector (+ (rest k) x) 0.0)))
     (drawn #:trail places
            #:marks (oscillator-marks n places rest side)
            #:shapes (oscillator-shapes places end side l)))))

(define (oscillator-shapes centers end side l)
  (define one? (null? (cdr centers)))
  (define half (vector (/ side 2.0) 0.0))
  (define lefts (cons origin (for/list ([c (in-list centers)]) (add c half))))
  (define rights
    (append (for/list ([c (in-list centers)]) (minus c half))
            (if one? '() (list (vector end 0.0)))))
  (define (upright x from to) (wall (vector x (* from l)) (vector x (* to l)) #:depth (* 0.1 l)))
  (list (upright 0.0 -0.35 0.35)
        (if one? '() (upright end 0.35 -0.35))
        (thin (vector 0.0 (* -0.55 side)) (vector end (* -0.55 side)))
        (for/list ([a (in-list lefts)] [b (in-list rights)]) (spring a b #:width (* 0.14 l)))
        (for/list ([c (in-list centers)] [color (in-cycle accents)])
          (block c side side #:color color))))

(define (oscillator-marks n centers rest side)
  (for/list ([c (in-list centers)] [k (in-naturals)])
    (define (name letter) (numbered letter (+ k 1) n))
    (define-values (zero end)
      (values (vector (rest k) (* 1.1 side)) (vector (at-x c) (* 1.1 side))))
    (list (dashed (vector (rest k) (* -0.55 side)) (add zero (vector 0.0 (* 0.3 side))))
          (polyline (list zero end) #:arrows 'end #:color (cadr accents) #:width 1.5)
          (label (between zero end 0.5) (name "x") #:anchor 'above #:color (cadr accents))
          (label (add c (vector 0.0 (* -0.6 side))) (name "m") #:anchor 'below)
          (if (= k 0)
              (label (vector (* 0.5 (- (at-x c) (/ side 2))) (* 0.35 side)) "k" #:anchor 'above)
              '()))))

;; r and θ; or x and y of the bob with #:rectangular? #t
(define (draw-spring-pendulum #:length [length 1] #:rectangular? [rectangular? #f]
                              #:width [width 300])
  (define l (check-length 'draw-spring-pendulum "the length" length))
  (mechanism
   `(draw-spring-pendulum #:length ,length ,@(if rectangular? '(#:rectangular? #t) '()))
   #:bounds (scaled l '(-1.7 1.7 -2.2 0.8))
   #:width width #:coordinates '(2)
   #:sample (if rectangular? (list (* 0.7 l) (* -1.0 l)) (list (* 1.2 l) 0.55))
   #:axes (if rectangular? '("x" "y") '("r" "θ"))
   (lambda (t q)
     (define b (if rectangular? q (below origin (vector-ref q 0) (vector-ref q 1))))
     (drawn #:trail (list b)
            #:marks (list (dashed origin (below origin (* 1.2 l) 0.0))
                          (swing-mark origin (direction b) (* 0.6 l) "θ")
                          (length-mark origin b "r" #:offset (* 0.25 l))
                          (name-beside b "m"))
            #:shapes (list (mount origin (* 0.3 l) (* 0.09 l))
                           (spring origin b #:width (* 0.16 l) #:coils 10)
                           (bob b (* 0.1 l)))))))
