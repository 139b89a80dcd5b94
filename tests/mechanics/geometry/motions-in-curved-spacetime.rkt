#lang racket/base
;; Numbers of general relativity, by geodesics and vectors carried along them, against closed forms.
;;
;; Lengths are in kilometres, times in kilometres of light: G M/c² of the Sun is 1.476625 km
;; (G M = 1.32712440018e11 km³/s², c = 299792.458 km/s).

(require mechanics mechanics/geometry
         "../support/checks.rkt" "../support/close.rkt")

(define c 299792.458)
(define sun (/ 1.32712440018e11 (square c)))
(define earth (/ 398600.4418 (square c)))
(define arc-second (/ pi 648000))

;; Schwarzschild's metric
(define-coordinates (up t r theta phi) spacetime-sphere)
(define (Schwarzschild M)
  (define A (- 1 (/ (* 2 M) r)))
  (make-metric (lambda (u v)
                 (+ (* -1 A (dt u) (dt v)) (* (/ 1 A) (dr u) (dr v))
                    (* (square r) (dtheta u) (dtheta v))
                    (* (square r) (square (sin theta)) (dphi u) (dphi v))))
               spacetime-sphere))

;; In the plane of the equator, in one chart
(define (follow M r rates end . events)
  (evolve-geodesic (Schwarzschild M) spacetime-sphere
                   (up 0 (up 0 r (/ pi 2) 0) (up (car rates) (cadr rates) 0 (caddr rates)))
                   end #:events events #:charts (list spacetime-sphere) #:tolerance 1e-14))

(define (part state i) (ref (coordinate state) i))
(define (rate state i) (ref (velocity state) i))

(test-case "parallel transport round a circle of the sphere turns a vector by 2π(1 − cos θ)"
  ;; in the sense of the walk, against the directions of south and east
  (define g (coordinate-system->metric S2-spherical))
  (for ([theta '(0.3 0.7 1.2 2.0)])
    (define carried
      (evolve-parallel-transport g S2-spherical (lambda (t) (up theta t)) (up 1.0 0.0)
                                 0 (* 2 pi) #:tolerance 1e-13))
    (define u (coordinate (trajectory-final-state carried)))
    (define turned (atan (* (sin theta) (ref u 1)) (ref u 0)))
    (check-close ((principal-value pi) (- turned (* 2 pi (- 1 (cos theta))))) 0 1e-10)))

(test-case "a vector carried along a great circle through the poles keeps its angle to it"
  (define g (coordinate-system->metric S2-spherical))
  (define tr (evolve-geodesic g S2-spherical (up 0 (up 1.0 0.3) (up -1.0 0.0)) 5))
  (define carried (evolve-parallel-transport g S2-spherical tr (up 0.6 (/ 0.8 (sin 1.0))) 0 5))
  ;; after 5 past one pole and the other, at θ = 2π − 4, again going north, as at the start
  (define theta (- (* 2 pi) 4))
  (check-close (coordinate (carried 5)) (up 0.6 (/ 0.8 (sin theta))) 1e-9)
  (check-equal? (carried 5) (carried 5.0))
  ;; from the very time at which charts change, forth and back
  (define changes (map car (trajectory-chart-changes tr)))
  (check-true (pair? changes))
  (for* ([t changes] [end '(0 5)])
    (define on (evolve-parallel-transport g S2-spherical tr (coordinate (carried t)) t end))
    (check-close (trajectory-end on) end 1e-12)
    (check-close (coordinate (trajectory-final-state on)) (coordinate (carried end)) 1e-9))
  (define back (evolve-parallel-transport g S2-spherical tr (coordinate (carried 5)) 5 0))
  (check-close (coordinate (back 0)) (up 0.6 (/ 0.8 (sin 1.0))) 1e-9))

(test-case "the perihelion of Mercury moves by 42.98 seconds of arc in a century"
  (define-values (a e days) (values 57909050.0 0.205630 87.9691))
  (define-values (near far) (values (* a (- 1 e)) (* a (+ 1 e))))
  ;; angular momentum and energy from ṙ = 0 at both distances
  (define (u k r) (/ 1 (expt r k)))
  (define ell
    (sqrt (/ (* 2 sun (- (u 1 near) (u 1 far)))
             (- (u 2 near) (u 2 far) (* 2 sun (- (u 3 near) (u 3 far)))))))
  (define A (- 1 (/ (* 2 sun) near)))
  (define E (sqrt (* A (+ 1 (square (/ ell near))))))
  (define year-of-Mercury (* 86400 days c))
  (define tr
    (follow sun near (list (/ E A) 0 (/ ell (square near))) (* 1.01 year-of-Mercury)
            (event (lambda (s) (rate s 1)) #:direction 'rising #:terminal? #t)))
  (define advance (- (part (trajectory-final-state tr) 3) (* 2 pi)))
  (define orbits (/ 36525 days))
  (check-close (/ (* orbits advance) arc-second) 42.98 0.005)
  (check-close (/ advance (/ (* 6 pi sun) (* a (- 1 (square e))))) 1 1e-4))

(test-case "light that grazes the Sun is bent by 1.7512 seconds of arc"
  (define R 695700.0)
  (define A (- 1 (/ (* 2 sun) R)))
  ;; a null geodesic: −A ṫ² + R² φ̇² = 0 where ṙ = 0
  (define tr (follow sun R (list (/ 1 (sqrt A)) 0 (/ 1 R)) (* 1e7 R)))
  (define s (trajectory-final-state tr))
  ;; the direction of the motion, where space is flat
  (define direction (+ (part s 3) (atan (* (part s 1) (rate s 3)) (rate s 1))))
  (define bent (* 2 (- direction (/ pi 2))))
  (check-close (/ bent arc-second) 1.7512 2e-4)
  (check-close (/ bent (/ (* 4 sun) R)) 1 1e-5))

(test-case "a gyroscope in a circular orbit turns by 2π(1 − √(1 − 3M/r)), forward"
  (define (turned M r)
    (define Omega (sqrt (/ M (expt r 3))))
    (define ut (/ 1 (sqrt (- 1 (/ (* 3 M) r)))))
    (define orbit (lambda (tau) (up (* ut tau) r (/ pi 2) (* Omega ut tau))))
    (define period (/ (* 2 pi) (* Omega ut)))
    ;; a vector that points away from the centre, of the rest frame
    (define carried
      (evolve-parallel-transport (Schwarzschild M) spacetime-sphere orbit (up 0 1.0 0 0) 0 period
                                 #:tolerance 1e-14))
    (define u (coordinate (trajectory-final-state carried)))
    ;; radially it is cos of the angle times what it was
    (define angle (acos (ref u 1)))
    (if (> (ref u 3) 0) angle (- (* 2 pi) angle)))
  (for ([M '(0.01 0.05 0.1)])
    (check-close (turned M 1.0) (* 2 pi (- 1 (sqrt (- 1 (* 3 M))))) 1e-10)))

(test-case "Gravity Probe B's gyroscopes turned by 6.6 seconds of arc in a year"
  ;; at 7027.4 km; the direction follows from the part along the orbit, for the angle is small
  (define-values (M r) (values earth 7027.4))
  (define Omega (sqrt (/ M (expt r 3))))
  (define ut (/ 1 (sqrt (- 1 (/ (* 3 M) r)))))
  (define orbit (lambda (tau) (up (* ut tau) r (/ pi 2) (* Omega ut tau))))
  (define period (/ (* 2 pi) (* Omega ut)))
  (define carried
    (evolve-parallel-transport (Schwarzschild M) spacetime-sphere orbit (up 0 1.0 0 0) 0 period
                               #:tolerance 1e-14))
  (define angle (* r (ref (coordinate (trajectory-final-state carried)) 3)))
  (define orbits (/ (* 365.25 86400 c) period))
  (check-close (/ (* orbits angle) arc-second) 6.6 0.05))

(test-case "light that climbs is redder"
  ;; the frequency for an observer at rest is −g(k, u) = A ṫ/√A
  (define (frequency M s)
    (* (rate s 0) (sqrt (- 1 (/ (* 2 M) (part s 1))))))
  (for ([M (list 0.3 sun)] [r (list 1.0 695700.0)])
    (define A (- 1 (/ (* 2 M) r)))
    (define tr (follow M r (list (/ 1 A) 1 0) (* 100 r)))
    (define-values (low high) (values (tr 0) (trajectory-final-state tr)))
    (check-close (/ (frequency M high) (frequency M low))
                 (sqrt (/ A (- 1 (/ (* 2 M) (part high 1))))) 1e-12))
  ;; from the Sun to far away by 2.12 millionths, as by 636 m/s
  (check-close (* c 1000 (- 1 (sqrt (- 1 (/ (* 2 sun) 695700))))) 636.3 0.1))
