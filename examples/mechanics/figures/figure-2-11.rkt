#lang mechanics
;; Spin and orbit, the angles  (SICM 2.11.2, Figure 2.11)
;;
;; A moon on its ellipse, drawn with a long axis, at eight times of its orbit.  The line to the
;; planet has the angle f, the long axis θ; between perihelion and aphelion the two part, and
;; meet there again when the moon turns once in an orbit.

(require mechanics/plot "orbits.rkt")

(define e 0.4)
(define motion (follow 0. e 1. 1.))
(define picture (frame -1.6 1. -1.3 1.3 #:width 400 #:height 400 #:aspect-ratio 'equal))

(define (place f)
  (define R (/ (- 1 (square e)) (+ 1 (* e (cos f)))))
  (up (* R (cos f)) (* R (sin f))))
(plot-parametric picture place 0. orbit)
(plot-point picture 0. 0. #:size 10)

(define (moon center theta)
  (lambda (s) (+ center (* 0.15 (cos s) (up (cos theta) (sin theta)))
                 (* 0.07 (sin s) (up (* -1 (sin theta)) (cos theta))))))
(for ([k 8])
  (define s (motion (/ k 8.)))
  (define center (place (ref s 3)))
  (plot-line picture 0. 0. (ref center 0) (ref center 1) #:style 'dot)
  (plot-parametric picture (moon center (ref s 1)) 0. orbit #:color 'blue)
  (define end ((moon center (ref s 1)) 0.))
  (plot-line picture (ref center 0) (ref center 1) (ref end 0) (ref end 1) #:color 'blue))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-2-11.png"))

(module+ test
  (require rackunit)
  (test-case "a round moon turns evenly; the line to the planet does not"
    (for ([k 8]) (check-= (ref (motion (/ k 8.)) 1) (* orbit k 1/8) 1e-9))
    (check-true (> (- (ref (motion 0.25) 3) (ref (motion 0.25) 1)) (* 1.5 e))))
  (test-case "both agree half an orbit on, and at its end"
    (for ([t '(0.5 1.)]) (check-= (off-line (motion t)) 0 1e-9)))
  (test-case "the orbit is an ellipse about the planet: equal areas in equal times"
    (define (swept-rate f) (* (square (place f)) (ref ((spin-orbit-sysder orbit 0. e)
                                                       (up 0. 0. 0. f)) 3)))
    (for ([f '(1. 2. 3.)]) (check-= (swept-rate f) (swept-rate 0.) 1e-12))))
