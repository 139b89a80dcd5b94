#lang mechanics
;; A black hole: its metric, orbits that turn, light that is bent, a gyroscope.

(require mechanics/geometry mechanics/plot)
(provide picture)

(define-coordinates (up t r theta phi) spacetime-sphere)
(define (Schwarzschild M)
  (define A (- 1 (/ (* 2 M) r)))
  (make-metric (lambda (u v)
                 (+ (* -1 A (dt u) (dt v)) (* (/ 1 A) (dr u) (dr v))
                    (* (square r) (dtheta u) (dtheta v))
                    (* (square r) (square (sin theta)) (dphi u) (dphi v))))
               spacetime-sphere))

;; A geodesic in the plane of the equator.  Far from it no other chart is wanted.
(define (follow M r rates end . events)
  (evolve-geodesic (Schwarzschild M) spacetime-sphere
                   (up 0 (up 0 r (/ pi 2) 0) (up (ref rates 0) (ref rates 1) 0 (ref rates 2)))
                   end #:events events #:charts (list spacetime-sphere) #:tolerance 1e-13))
(define (place state)
  (define q (coordinate state))
  (* (ref q 1) (up (cos (ref q 3)) (sin (ref q 3)))))

;; An orbit between r = 10 and 30 (M = 1).  Energy and angular momentum are those with which both
;; are turning points; the perihelion moves by more than a quarter of a turn each time.
(define-values (near far) (values 10. 30.))
(define (u k r) (expt r (- k)))
(define ell
  (sqrt (/ (* 2 (- (u 1 near) (u 1 far)))
           (- (u 2 near) (u 2 far) (* 2 (- (u 3 near) (u 3 far)))))))
(define A (- 1 (/ 2 near)))
(define E (sqrt (* A (+ 1 (square (/ ell near))))))
(define orbit
  (follow 1. near (up (/ E A) 0 (/ ell (square near))) 4000
          (event (lambda (s) (ref (velocity s) 1)) #:direction 'rising)))
(define perihelia (map occurrence-state (trajectory-events orbit)))
(define advance (- (ref (coordinate (car perihelia)) 3) (* 2 pi)))
advance

;; The same as an integral over r between the turning points, by u = 1/r = p − h cos x
(define exact
  (let ([p (* 1/2 (+ (u 1 near) (u 1 far)))] [h (* 1/2 (- (u 1 near) (u 1 far)))])
    (- (* 2 (definite-integral
              (lambda (x)
                (define w (- p (* h (cos x))))
                ;; (du/dφ)² = 2 (u − u₁)(u − u₂)(u − u₃), whose roots have the sum 1/2
                (/ 1 (sqrt (* 2 (- (- 1/2 (* 2 p)) w)))))
              0 pi))
       (* 2 pi))))
exact

;; Light passes at r = 6: ṙ = 0 there, and −A ṫ² + r² φ̇² = 0.
(define light (follow 1. 6. (up (/ 1 (sqrt (- 1 (/ 2 6.)))) 0 (/ 1 6.)) 1e5))
(define bent
  (let* ([s (trajectory-final-state light)] [q (coordinate s)] [v (velocity s)])
    (* 2 (- (+ (ref q 3) (atan (* (ref q 1) (ref v 3)) (ref v 1))) (/ pi 2)))))
bent

;; A gyroscope in the circular orbit at r = 10 turns, against the stars, once round by this angle.
(define turned
  (let* ([r 10.] [Omega (sqrt (/ 1 (expt r 3)))] [ut (/ 1 (sqrt (- 1 (/ 3 r))))]
         [once-round (/ (* 2 pi) (* Omega ut))])
    (define carried
      (evolve-parallel-transport (Schwarzschild 1.) spacetime-sphere
                                 (lambda (tau) (up (* ut tau) r (/ pi 2) (* Omega ut tau)))
                                 (up 0 1. 0 0) 0 once-round #:tolerance 1e-13))
    (acos (ref (coordinate (trajectory-final-state carried)) 1))))
turned
(* 2 pi (- 1 (sqrt (- 1 (/ 3 10)))))

;; The orbit in blue, light in red, the horizon in black.
(define picture (frame -35 35 -35 35 #:width 400 #:height 400 #:aspect-ratio 'equal))
(plot-parametric picture (lambda (t) (place (orbit t))) 0. (trajectory-end orbit) 2.
                 #:color 'blue)
(define (mirrored side p) (up (ref p 0) (* side (ref p 1))))
(for ([side '(1 -1)])
  (plot-parametric picture (lambda (t) (mirrored side (place (light t)))) 0. 60. #:color 'red))
(plot-parametric picture (lambda (x) (* 2 (up (cos x) (sin x)))) 0. (* 2 pi) #:width 2)
picture

(module+ main
  (require "../figures/save.rkt")
  (save-figure picture "black-hole-orbits.png"))

(module+ test
  (require rackunit)
  (test-case "the perihelion moves as the integral says" (check-= advance exact 1e-9))
  (test-case "light is bent by more than 4 M/r" (check-true (< 4/6 bent 1.5)))
  (test-case "the gyroscope" (check-= turned (* 2 pi (- 1 (sqrt (- 1 (/ 3 10))))) 1e-10)))
