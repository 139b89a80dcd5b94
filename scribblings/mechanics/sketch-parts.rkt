#lang racket/base
;; Parts of sketches of the manual, besides the shapes of mechanics/animate: points,
;; colors, axes, curves.

(require mechanics/animate)

(provide at axes curve ellipse pi blue orange gray)

(define pi 3.141592653589793)

;; A point of the plane
(define (at x y) (cons x y))

(define blue '(38 110 190))
(define orange '(205 85 35))
(define gray '(140 140 140))

(define (axes x-end y-end x-name y-name)
  (for/list ([end (list (at x-end 0) (at 0 y-end))] [name (list x-name y-name)]
             [anchor '(below left)])
    (list (polyline (list (at 0 0) end) #:width 1 #:color gray #:arrows 'end)
          (label end name #:anchor anchor #:color gray))))

(define (curve f from to #:color [color blue] #:style [style 'solid])
  (polyline (for/list ([k 61]) (let ([x (+ from (* (- to from) (/ k 60)))]) (at x (f x))))
            #:color color #:style style))

;; Half axes a and b, the first turned by the angle.
(define (ellipse center a b #:angle [angle 0.0] #:fill [fill #f] #:style [style 'solid]
                 #:width [width 1.5] #:color [color "black"])
  (define (on phi)
    (define-values (x y) (values (* a (cos phi)) (* b (sin phi))))
    (at (+ (car center) (- (* x (cos angle)) (* y (sin angle))))
        (+ (cdr center) (* x (sin angle)) (* y (cos angle)))))
  (polyline (for/list ([k 49]) (on (* k pi 1/24)))
            #:closed? #t #:fill fill #:style style #:width width #:color color))
