#lang mechanics
;; Motions on a sphere: a pendulum through its pole, and vectors carried along curves.

(require mechanics/geometry mechanics/plot "../figures/solid.rkt")
(provide picture)

;; The spherical pendulum with l = m = 1; θ is counted from the bottom.
(define ((L g) (up t (up theta phi) (up thetadot phidot)))
  (+ (* 1/2 (+ (square thetadot) (square (* (sin theta) phidot))))
     (* g (cos theta))))

;; Pushed towards the bottom, where θ and φ are singular.  It is followed in other coordinates
;; there, and told in these.
(define start (up 0 (up 1. 0.3) (up -2. 0.)))
(define motion (evolve-on (L 9.8) S2-spherical start 10 #:tolerance 1e-12))
(coordinate (motion 10))
(length (trajectory-chart-changes motion))

;; Its energy stays, and θ = 0 is passed twice in each period: φ turns by π.
(define energy (Lagrangian->energy (L 9.8)))
(define off (- (energy (motion 10)) (energy start)))
(< (abs off) 1e-10)

;; A vector that is carried round the circle of colatitude θ turns, in the sense of the walk, by
;; 2π(1 − cos θ), the area of the cap.
(define g (coordinate-system->metric S2-spherical))
(define (turned theta)
  (define walk (lambda (t) (up theta t)))
  (define carried
    (evolve-parallel-transport g S2-spherical walk (up 1. 0.) 0 (* 2 pi) #:tolerance 1e-12))
  (define u (coordinate (trajectory-final-state carried)))
  ((principal-value (* 2 pi)) (atan (* (sin theta) (ref u 1)) (ref u 0))))
(turned 0.7)
(* 2 pi (- 1 (cos 0.7)))

;; The picture: great circles, and a vector on its way round the circle of colatitude 0.7.
(define picture (frame -1.2 1.2 -1.1 1.2 #:width 400 #:height 380 #:aspect-ratio 'equal))
(define (in-space q)
  (define-values (theta phi) (values (ref q 0) (ref q 1)))
  (up (* (sin theta) (cos phi)) (* (sin theta) (sin phi)) (cos theta)))

(for ([k 6])
  (define great
    (evolve-geodesic g S2-spherical
                     (up 0 (up (/ pi 2) 0.) (up (sin (* k pi 1/6)) (cos (* k pi 1/6)))) (* 2 pi)))
  (draw-curve picture (lambda (t) (in-space (coordinate (great t)))) 0. (* 2 pi)
              #:color '(170 170 170)))

(define theta 0.7)
(define carried
  (evolve-parallel-transport g S2-spherical (lambda (t) (up theta t)) (up 1. 0.) 0 (* 2 pi)))
(draw-curve picture (lambda (t) (in-space (up theta t))) 0. (* 2 pi) #:color 'blue)
(for ([k 17])
  (define t (* k pi 1/8))
  (define at (up theta t))
  (draw-line picture (in-space at)
             (+ (in-space at) (* 0.35 (* ((D in-space) at) (coordinate (carried t)))))
             #:color 'red #:width 2))
picture

(module+ main
  (require "../figures/save.rkt")
  (save-figure picture "sphere.png"))

(module+ test
  (require rackunit)
  (test-case "the energy stays" (check-= off 0 1e-10))
  (test-case "a vector turns by the area of the cap"
    (for ([theta '(0.3 0.7 1.2)])
      (check-= (turned theta) (* 2 pi (- 1 (cos theta))) 1e-10)))
  (test-case "the pendulum stays in its plane"
    (for ([t 11])
      (check-= (sin (- (ref (coordinate (motion t)) 1) 0.3)) 0 1e-9))))
