#lang racket/base
;; Systems whose motion is known: a disk that rolls, a ball on a turntable, any track.

(require mechanics
         "../support/checks.rkt" "../support/session.rkt")

;; ---------------------------------------------------------------------------
;; A disk that rolls and leans: centre x and y, heading φ, inclination θ, angle of rolling ψ.
;; The point on the ground is at rest.

(define ((L-disk m R g) (up t (up x y φ θ ψ) (up vx vy vφ vθ vψ)))
  (define spin (- vψ (* vφ (cos θ))))
  (- (+ (* 1/2 m (+ (square vx) (square vy) (square (* R (cos θ) vθ))))
        (* 1/8 m (square R) (+ (square vθ) (square (* vφ (sin θ)))))
        (* 1/4 m (square R) (square spin)))
     (* m g R (sin θ))))
(define ((centre R) (up x y φ θ ψ) (up vx vy vφ vθ vψ))
  (define forwards (* R (- vψ (* vφ (cos θ)))))
  (define sideways (* -1 R (sin θ) vθ))
  (up (- (* forwards (cos φ)) (* sideways (sin φ)))
      (+ (* forwards (sin φ)) (* sideways (cos φ)))))
(define ((rolling R) t q v) (- (up (ref v 0) (ref v 1)) ((centre R) q v)))

(define disk-coordinates (up 'x 'y 'φ 'θ 'ψ))
(define disk-state
  (let ([c ((centre 'R) disk-coordinates (up 0 0 'vφ 'vθ 'vψ))])
    (up 't disk-coordinates (up (ref c 0) (ref c 1) 'vφ 'vθ 'vψ))))

(test-case "disk: nonholonomic, and the ground takes no power"
  (define rolls (nonholonomic (rolling 'R)))
  (check-eq? (verdict-status (Frobenius-test rolls disk-coordinates)) 'refuted)
  (check-identity (* ((constraint-forces (L-disk 'm 'R 'g) rolls) disk-state) (velocity disk-state))
                  0))

(test-case "disk: the equation of its inclination"
  (define a
    (ref ((constrained-accelerations (L-disk 'm 'R 'g) (nonholonomic (rolling 'R))) disk-state) 0))
  (check-identity (* 5/4 'R (ref a 3))
                  (+ (* 1/4 'R (square 'vφ) (sin 'θ) (cos 'θ))
                     (* 3/2 'R 'vφ (sin 'θ) (- 'vψ (* 'vφ (cos 'θ))))
                     (* -1 'g (cos 'θ)))))

(test-case "disk: upright it is stable from v² = g R/3 on; energy stays, and it does not slip"
  (define derivative (constrained-state-derivative (L-disk 1 1 1) (nonholonomic (rolling 1))))
  (define energy (Lagrangian->energy (L-disk 1 1 1)))
  (define (greatest-lean v²)
    (define v (sqrt v²))
    (define tr
      (evolve-trajectory derivative (up 0 (up 0 0 0 (+ :pi/2 1e-3) 0) (up v 0 0 0 v)) 15))
    (define last (trajectory-final-state tr))
    (check-= (energy last) (energy (tr 0)) 1e-7)
    (check-true (< (square ((rolling 1) 0 (coordinate last) (velocity last))) 1e-26))
    (for/fold ([most 0]) ([k 301])
      (max most (abs (- (ref (coordinate (tr (/ k 20))) 3) :pi/2)))))
  (check-true (< (greatest-lean 0.40) 0.02))
  (check-true (> (greatest-lean 0.25) 0.1)))

;; ---------------------------------------------------------------------------
;; A ball on a turntable, its orientation by Euler's angles

(define (angular-velocity (up x y φ θ ψ) (up vx vy vφ vθ vψ))
  (up (+ (* vθ (cos φ)) (* vψ (sin θ) (sin φ)))
      (- (* vθ (sin φ)) (* vψ (sin θ) (cos φ)))
      (+ vφ (* vψ (cos θ)))))
(define ((L-ball m R) (up t q v))
  (+ (* 1/2 m (+ (square (ref v 0)) (square (ref v 1))))
     (* 1/5 m (square R) (square (angular-velocity q v)))))
;; v + ω × (−R ẑ) = Ω ẑ × r
(define ((no-slip R Ω) t q v)
  (define ω (angular-velocity q v))
  (up (+ (ref v 0) (* -1 R (ref ω 1)) (* Ω (ref q 1)))
      (- (+ (ref v 1) (* R (ref ω 0))) (* Ω (ref q 0)))))

(test-case "turntable: the ball's centre goes round at two sevenths of the table's rate"
  (define q (up 'x 'y 'φ 'θ 'ψ))
  (define turning (up 0 0 'vφ 'vθ 'vψ))
  (define slip ((no-slip 'R 'Ω) 't q turning))
  (define v (- turning (up (ref slip 0) (ref slip 1) 0 0 0)))
  (define a
    (ref ((constrained-accelerations (L-ball 'm 'R) (nonholonomic (no-slip 'R 'Ω))) (up 't q v)) 0))
  (check-identity (ref a 0) (* -2/7 'Ω (ref v 1)))
  (check-identity (ref a 1) (* 2/7 'Ω (ref v 0))))

(test-case "turntable: after seven halves of a turn the ball is back"
  (define rolls (nonholonomic (no-slip 0.05 (* 2 :pi))))
  (define L (L-ball 1 0.05))
  (define tr
    (evolve-trajectory (constrained-state-derivative L rolls)
                       ((consistent-state L rolls) (up 0 (up 0.3 0 0 1 0) (up 0 0.2 0 0 0)))
                       3.5 #:tolerance 1e-11))
  (for ([k 2])
    (check-= (ref (coordinate (tr 3.5)) k) (ref (coordinate (tr 0)) k) 1e-8)))

;; ---------------------------------------------------------------------------
;; A track y = f(x), any f

(define ((L-mass m g) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (* m g y)))
(define ((track f) t (up x y)) (- y (f x)))

(test-case "any track: its force, and the equation of x alone"
  (define f (literal-function 'f))
  (define x (literal-function 'x))
  (define on-track (holonomic (track f)))
  (define state (up 't (up 'x (f 'x)) (up 'v (* ((D f) 'x) 'v))))
  (check-identity (ref ((constrained-accelerations (L-mass 'm 'g) on-track) state) 1)
                  (/ (* 'm (+ 'g (* (((expt D 2) f) 'x) (square 'v)))) (+ 1 (square ((D f) 'x)))))
  (define (by-x local) (up (coordinate local) (f (coordinate local))))
  (check-identity (((eliminate-multipliers (L-mass 'm 'g) on-track by-x) x) 't)
                  (up (((Lagrange-equations (compose (L-mass 'm 'g) (F->C by-x))) x) 't) 0)))

(test-case "hills cos x: a car too fast leaves where cos x vx² = g"
  (define on-hills (holonomic (track cos)))
  (define force (constrained-accelerations (L-mass 1 9.8) on-hills))
  (define leaves
    (event (lambda (s) (ref (force s) 1)) #:direction 'falling #:terminal? #t))
  (define (run v)
    (evolve-trajectory (constrained-state-derivative (L-mass 1 9.8) on-hills)
                       (up 0 (up (- :pi) -1) (up v 0)) 3 #:tolerance 1e-12 #:events leaves))
  (check-equal? (trajectory-events (run 6.8)) '())
  (define last (trajectory-final-state (run 7.2)))
  (check-= (* (cos (ref (coordinate last) 0)) (square (ref (velocity last) 0))) 9.8 1e-9))
