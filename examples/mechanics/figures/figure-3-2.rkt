#lang mechanics
;; A mass on a helical track  (SICM 3.1.1, Figure 3.2)
;;
;; The cylinder of exercise 3.6, with the track on it, at four times: the mass in red slides
;; down and turns the cylinder the other way.

(require mechanics/plot "solid.rkt")

;; M and m in kg, R in m, β in radians per m down, g in m/s²
(define-values (M m R beta g) (values 2. 1. 0.4 6. 9.8))
(define (L (up t (up theta z) (up thetadot zdot)))
  (+ (* 1/4 M (square R) (square thetadot))
     (* 1/2 m (+ (square (* R (+ thetadot (* beta zdot)))) (square zdot)))
     (* m g z)))
(define slide
  (evolve-trajectory (Hamiltonian->state-derivative (Lagrangian->Hamiltonian L))
                     (up 0. (up 0. 0.) (down 0. 0.)) 0.7 #:tolerance 1e-11))

(define picture (frame -0.6 3.2 -1.9 0.4 #:width 600 #:height 380 #:aspect-ratio 'equal))
(define (on-cylinder place angle z)
  (+ (up (* R (cos angle)) (* R (sin angle)) (* -1 z)) place))
(define (draw place s)
  (define-values (theta z) (values (ref s 1 0) (ref s 1 1)))
  (for ([height '(0. 1.8)])
    (draw-curve picture (lambda (a) (on-cylinder place a height)) 0. (* 2 pi)))
  (draw-curve picture (lambda (d) (on-cylinder place (+ theta (* beta d)) d)) 0. 1.8
              #:color 'blue)
  (define mass (seen (on-cylinder place (+ theta (* beta z)) z)))
  (plot-point picture (ref mass 0) (ref mass 1) #:color 'red #:size 9))
(for ([t '(0. 0.25 0.45 0.65)] [k 4]) (draw (* k (up -0.433 0.75 0)) (slide t)))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-3-2.png"))

(module+ test
  (require rackunit)
  (test-case "the mass falls as on a plane, and the cylinder turns backwards"
    (define a (/ g (+ 1 (/ (* (square (* R beta)) M) (+ M (* 2 m))))))
    (check-= (ref (slide 0.65) 1 1) (* 1/2 a (square 0.65)) 1e-9)
    (check-true (< (ref (slide 0.65) 1 0) 0)))
  (test-case "the angular momentum stays 0"
    (check-= (ref (slide 0.65) 2 0) 0 1e-12)))
