#lang racket/base
;; Motions through places where coordinates are singular, against equations without coordinates:
;; a vector of length 1 for the spherical pendulum, Euler's equations for bodies.

(require (only-in racket/list last)
         mechanics mechanics/geometry
         "../support/checks.rkt" "../support/close.rkt")

(define sharp-tolerance 1e-13)

;; ---------------------------------------------------------------------------
;; The spherical pendulum.  On the unit vector u, with l = m = 1 and gravity along −z,
;; u″ = −g ẑ + (g u_z − u′²) u.

(define g 9.8)

(define (L-pendulum local)
  (define-values (theta thetadot phidot)
    (values (ref (coordinate local) 0) (ref (velocity local) 0) (ref (velocity local) 1)))
  (- (* 1/2 (+ (square thetadot) (square (* (sin theta) phidot)))) (* g (cos theta))))

(define (vector-rates state)
  (define-values (u v) (values (coordinate state) (velocity state)))
  (define along (- (* g (ref u 2)) (square v)))
  (up 1 v (up (* along (ref u 0)) (* along (ref u 1)) (- (* along (ref u 2)) g))))

(define (unit q)
  (define-values (theta phi) (values (ref q 0) (ref q 1)))
  (up (* (sin theta) (cos phi)) (* (sin theta) (sin phi)) (cos theta)))

;; The state of the vector
(define (vector-state local)
  ((F->C (lambda (local) (unit (coordinate local)))) local))

(define (check-pendulum start end)
  (define tr (evolve-on L-pendulum S2-spherical start end #:tolerance sharp-tolerance))
  (define oracle (evolve-trajectory vector-rates (vector-state start) end
                                    #:tolerance sharp-tolerance))
  (for ([k 21])
    (define t (* (/ k 20) end))
    (check-close ((compose unit (chart S2-spherical)) (trajectory-point tr t))
                 (coordinate (oracle t)) 1e-10)
    (check-close (unit (coordinate (tr t))) (coordinate (oracle t)) 1e-10))
  tr)

(test-case "the spherical pendulum goes through its pole"
  (define tr (check-pendulum (up 0 (up 1.0 0.3) (up -4.5 0.0)) 10))
  (check-true (> (length (trajectory-chart-changes tr)) 10))
  (define E (Lagrangian->energy L-pendulum))
  (for ([s (trajectory-states tr)])
    (check-close (E s) (E (tr 0)) 1e-8)))

(test-case "and near to it, forward and backward in time"
  (for ([phidot '(1e-3 -0.05 1.0)] [end '(10 -10 10)])
    (check-pendulum (up 0 (up 1.0 0.3) (up -4.5 phidot)) end)))

(test-case "whole turns of the longitude are counted"
  (define start (up 0 (up 1.0 0.3) (up -4.5 0.05)))
  ;; the longitude only grows with the time, by nearly half a turn at each pass of a pole
  (for ([end '(20 -5)])
    (define tr (evolve-on L-pendulum S2-spherical start end #:tolerance sharp-tolerance))
    (define longitudes
      (for/list ([k (+ 1 (* 1000 (abs end)))]) (ref (coordinate (tr (* k (sgn end) 1/1000))) 1)))
    (for ([a longitudes] [b (cdr longitudes)])
      (check-true (< 0 (* (sgn end) (- b a)) pi)))
    (check-true (> (abs (last longitudes)) (* 2 (abs end))))))

;; A conical pendulum about the pole of the chart at home, which it never is followed in:
;; ω² cos α = g, and a point at the distance r from the origin is seen there at tan(α/2) = r.
(test-case "and all those of a motion in another chart, forward and backward"
  (define r 0.1)
  (define omega (sqrt (/ g (cos (* 2 (atan r))))))
  (define start (up 0 ((point S2-stereographic) (up r 0.0)) (up 0.0 (* r omega))))
  (for ([end '(12 -12)])
    (define tr (evolve-on L-pendulum S2-spherical start end #:charts (list S2-stereographic)))
    (for ([k 121])
      (define t (* k (/ end 120)))
      (check-close (ref (coordinate (tr t)) 1) (* omega t) 1e-7))))

(test-case "a straight line past the origin of polar coordinates: their angle alone has turns"
  (define (L-free local)
    (define-values (r rdot thetadot)
      (values (ref (coordinate local) 0) (ref (velocity local) 0) (ref (velocity local) 1)))
    (* 1/2 (+ (square rdot) (square (* r thetadot)))))
  (define tr (evolve-on L-free R2-polar (up 0 (up 1.0 3.0) (up -1.0 0.05)) 3
                        #:tolerance sharp-tolerance))
  (check-true (pair? (trajectory-chart-changes tr)))
  (for ([k 31])
    (define t (/ k 10))
    (check-close (coordinate (tr t))
                 (up (sqrt (+ (square (- 1 t)) (square (* 0.05 t))))
                     (+ 3.0 (atan (* 0.05 t) (- 1.0 t))))
                 1e-10)))

(test-case "what is read is the same on both sides of a change of charts"
  (define tr (evolve-on L-pendulum S2-spherical (up 0 (up 1.0 0.3) (up -4.5 0.05)) 5
                        #:tolerance sharp-tolerance))
  (for ([change (trajectory-chart-changes tr)])
    (define t (car change))
    (define by 1e-9)
    (define-values (before after) (values (tr (- t by)) (tr (+ t by))))
    (check-close (- (coordinate after) (coordinate before))
                 (* 2 by (velocity (tr t))) 1e-11)
    (check-close (trajectory-momentum tr (- t by)) (trajectory-momentum tr (+ t by)) 1e-7)))

(test-case "the momentum about the axis is conserved through all charts"
  (define start (up 0 (up 1.0 0.3) (up -4.5 0.05)))
  (define tr (evolve-on L-pendulum S2-spherical start 10 #:tolerance sharp-tolerance))
  (for ([k 101])
    (check-close (ref (trajectory-momentum tr (/ k 10)) 1) (* (square (sin 1.0)) 0.05) 1e-11)))

(test-case "a driven pendulum: the Lagrangian depends on the time"
  (define ((driven lift) local)
    (define theta (ref (coordinate local) 0))
    (- (L-pendulum local) (* 3 (cos (* 7 (time local))) (cos theta) lift)))
  (define (rates state)
    (define u (coordinate state))
    (define f (+ g (* 3 (cos (* 7 (time state))))))
    (define along (- (* f (ref u 2)) (square (velocity state))))
    (up 1 (velocity state)
        (up (* along (ref u 0)) (* along (ref u 1)) (- (* along (ref u 2)) f))))
  (define start (up 0.5 (up 1.0 0.3) (up -4.5 0.0)))
  (define tr (evolve-on (driven 1) S2-spherical start 6 #:tolerance sharp-tolerance))
  (define oracle (evolve-trajectory rates (vector-state start) 6 #:tolerance sharp-tolerance))
  (check-close (unit (coordinate (trajectory-final-state tr)))
               (coordinate (trajectory-final-state oracle)) 1e-10))

(test-case "Lagrangians may be given for several charts, and the start as a point of one of them"
  (define (L-plane local)               ; from the north pole: u = (2x, 2y, r² − 1)/(1 + r²)
    (define-values (x y) (values (ref (coordinate local) 0) (ref (coordinate local) 1)))
    (define r^2 (+ (square x) (square y)))
    (- (* 2 (/ (square (velocity local)) (square (+ 1 r^2))))
       (* g (/ (- r^2 1) (+ r^2 1)))))
  (define both (list (list S2-spherical L-pendulum) (list S2-stereographic L-plane)))
  (define start (up 0 ((point S2-stereographic) (up 0.0 0.0)) (up 3.0 0.0)))
  (define tr (evolve-on both S2-spherical start 2 #:tolerance sharp-tolerance))
  (define oracle (evolve-trajectory vector-rates (up 0 (up 0.0 0.0 -1.0) (up 6.0 0.0 0.0)) 2
                                    #:tolerance sharp-tolerance))
  (check-close (unit (coordinate (tr 2))) (coordinate (oracle 2)) 1e-10))

;; ---------------------------------------------------------------------------
;; Bodies.  Of the momentum l in the body and the axes of space γₖ there, l′ = l × ω + torque,
;; γₖ′ = γₖ × ω.  The rotation M takes the body to space: its rows are the γₖ.

;; torque : vertical in the body -> up of 3
(define ((body-rates A B C torque) state)
  (define l (ref state 1))
  (define omega (up (/ (ref l 0) A) (/ (ref l 1) B) (/ (ref l 2) C)))
  (define axes (ref state 2))
  (up 1
      (+ (cross-product l omega) (torque (ref axes 2)))
      (up (cross-product (ref axes 0) omega) (cross-product (ref axes 1) omega)
          (cross-product (ref axes 2) omega))))

(define (check-body L A B C torque start end)
  (define tr (evolve-on L Euler-angles start end #:tolerance sharp-tolerance))
  (define M (Euler->M (coordinate start)))
  (define omega (Euler-state->omega-body start))
  (define oracle
    (evolve-trajectory (body-rates A B C torque)
                       (up 0 (up (* A (ref omega 0)) (* B (ref omega 1)) (* C (ref omega 2)))
                           (rows M))
                       end #:tolerance sharp-tolerance))
  (for ([k 21])
    (define t (* (/ k 20) end))
    (check-close (rows (Euler->M (coordinate (tr t)))) (ref (oracle t) 2) 1e-10))
  tr)

(define (rows M) (apply up (for/list ([i 3]) (apply up (for/list ([j 3]) (matrix-ref M i j))))))
(define (no-torque vertical) (up 0 0 0))

(test-case "a free rigid body goes through θ = 0"
  ;; from θ = 0.5 the node stays where it is: the rotation is about it
  (define tr (check-body (T-rigid-body 1 2 3) 1 2 3 no-torque
                         (up 0 (up 0.5 0.2 0.0) (up -1.0 0.0 0.0)) 10))
  (check-true (pair? (trajectory-chart-changes tr)))
  (void (check-body (T-rigid-body 1 2 3) 1 2 3 no-torque
                    (up 0 (up 0.5 0.2 0.1) (up -1.0 0.4 -0.3)) 20)))

(test-case "a top goes through the vertical"
  (define ((L-top A C gMR) local)
    (- ((T-rigid-body A A C) local) (* gMR (cos (ref (coordinate local) 0)))))
  (define ((torque gMR) vertical) (* gMR (cross-product vertical (up 0 0 1))))
  ;; p_φ = p_ψ: with φ' (1 + cos θ) = ψ' C/A ... chosen so that it rises to θ = 0 and beyond
  (define-values (A C gMR theta psidot) (values 1.0 0.5 1.0 0.4 1.0))
  (define phidot (/ (* C psidot) (- (* A (+ 1 (cos theta))) (* C (cos theta)))))
  (define tr (check-body (L-top A C gMR) A A C (torque gMR)
                         (up 0 (up theta 0.2 0.3) (up -2.0 phidot psidot)) 10))
  (check-true (pair? (trajectory-chart-changes tr)))
  (for ([t 11])
    (define p (trajectory-momentum tr t))
    (check-close (ref p 1) (ref p 2) 1e-10)))

(test-case "a path along which a vector is carried may give points, in any chart"
  (define (carried path)
    (coordinate
     ((evolve-parallel-transport S2-metric S2-spherical path (up 1 0) 0 2) 2)))
  (define by-coordinates (carried (lambda (t) (up 1 t))))
  (define equal-points (list (lambda (t) ((point S2-spherical) (up 1 t)))
                             (lambda (t)
                               ((point S2-stereographic)
                                (let ([rho (/ (sin 1) (- 1 (cos 1)))])
                                  (up (* rho (cos t)) (* rho (sin t))))))))
  (for ([path equal-points])
    (for ([a (structure->list (carried path))] [b (structure->list by-coordinates)])
      (check-within a b 1e-9))))
