#lang racket/base
;; Equations with multipliers: pendulum, Atwood's machine, a mass on a circle.

(require mechanics
         (only-in mechanics/book L-free-particle)
         "../support/checks.rkt" "../support/session.rkt")

(define-syntax-rule (check-proved verdict) (check-eq? (verdict-status verdict) 'proved))
(define-syntax-rule (check-refuted verdict) (check-eq? (verdict-status verdict) 'refuted))

(define lambda-path (literal-function 'lambda))

;; ---------------------------------------------------------------------------
;; A plane pendulum in rectangular coordinates

(define ((L-mass m g) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (* m g y)))
(define rod (holonomic (lambda (t q) (- (sqrt (square q)) 'l))))
(define xy (up (literal-function 'x) (literal-function 'y)))
(define (from-bottom local)
  (define θ (coordinate local))
  (up (* 'l (sin θ)) (* -1 'l (cos θ))))

(test-case "pendulum: m ẍ = λ x/l and m ÿ = −m g + λ y/l"
  (define residual (((constrained-Lagrange-equations (L-mass 'm 'g) rod) xy lambda-path) 't))
  (define-values (x y) (values (literal-function 'x) (literal-function 'y)))
  (define r (sqrt (+ (square (x 't)) (square (y 't)))))
  (check-identity residual
                  (up (down (- (* 'm (((expt D 2) x) 't)) (* (lambda-path 't) (/ (x 't) r)))
                            (+ (* 'm (((expt D 2) y) 't)) (* 'm 'g)
                               (* -1 (lambda-path 't) (/ (y 't) r))))
                      (- r 'l))))

(test-case "pendulum: the tension is m v²/l + m g cos θ"
  (define state ((F->C from-bottom) (up 't 'θ 'v)))
  (define a (assuming ('(> l 0)) ((constrained-accelerations (L-mass 'm 'g) rod) state)))
  (assuming ('(> l 0))
    (check-identity (ref a 1) (* -1 (+ (* 'm 'l (square 'v)) (* 'm 'g (cos 'θ)))))
    (check-identity ((constraint-forces (L-mass 'm 'g) rod) state)
                    (* (ref a 1) (down (sin 'θ) (- (cos 'θ)))))))

(test-case "pendulum: eliminated, the equation of the angle"
  (define θ (literal-function 'θ))
  (define (L-angle local) ((L-mass 'm 'g) ((F->C from-bottom) local)))
  (define left (((eliminate-multipliers (L-mass 'm 'g) rod from-bottom) θ) 't))
  (assuming ('(> l 0))
    (check-identity left (up (((Lagrange-equations L-angle) θ) 't) 0)))
  ;; along the null space of the Jacobian, whose basis is (cos θ, sin θ)
  (define along (((eliminate-multipliers (L-mass 'm 'g) rod) (compose from-bottom (Gamma θ))) 't))
  (assuming ('(> l 0))
    (check-identity (ref left 0) (* 'l (ref along 0)))))

(test-case "the augmented Lagrangian has the equations with multipliers"
  (define augmented
    (((Lagrange-equations (augmented-Lagrangian (L-mass 'm 'g) rod)) (up xy lambda-path)) 't))
  (define constrained
    (((constrained-Lagrange-equations (L-mass 'm 'g) rod) xy lambda-path) 't))
  (check-identity (ref augmented 0) (ref constrained 0))
  (check-identity (ref augmented 1) (- (ref constrained 1))))

(test-case "a proposed motion with its multiplier: rotation without gravity"
  (define (circle t) (up (* 'l (sin (* 'omega t))) (* -1 'l (cos (* 'omega t)))))
  (define (tension t) (* -1 'm 'l (square 'omega)))
  (define (verdict multipliers #:g [g 0])
    (assuming ('(> l 0))
      (verify-solution (L-mass 'm g) circle #:constraints rod #:multipliers multipliers)))
  (check-proved (verdict tension))
  (check-refuted (verdict (lambda (t) 'c)))
  (check-refuted (verdict tension #:g 'g))
  ;; is there a multiplier?
  (check-proved (verdict #f))
  (check-refuted (verdict #f #:g 'g)))

(test-case "with a force outside the Lagrangian"
  (define (drag local) (* -1 'b (flip (velocity local))))
  (define state ((F->C from-bottom) (up 't 'θ 'v)))
  (assuming ('(> l 0))
    (define a (ref ((constrained-accelerations (L-mass 'm 'g) rod #:force drag) state) 0))
    (check-identity (* a (down (cos 'θ) (sin 'θ)))
                    (+ (* -1 'g (sin 'θ)) (/ (* -1 'b 'l 'v) 'm)))))

;; ---------------------------------------------------------------------------
;; Atwood's machine

(define ((L-Atwood m1 m2 g) (up t (up x1 x2) (up v1 v2)))
  (+ (* 1/2 m1 (square v1)) (* 1/2 m2 (square v2)) (* m1 g x1) (* m2 g x2)))
(define string-of-length (holonomic (lambda (t q) (- (+ (ref q 0) (ref q 1)) 'l))))

(test-case "Atwood's machine: acceleration and tension"
  (define m (+ 'm_1 'm_2))
  (check-identity ((constrained-accelerations (L-Atwood 'm_1 'm_2 'g) string-of-length)
                   (up 't (up 'x_1 'x_2) (up 'v_1 'v_2)))
                  (up (up (/ (* (- 'm_1 'm_2) 'g) m) (/ (* (- 'm_2 'm_1) 'g) m))
                      (/ (* -2 'm_1 'm_2 'g) m))))

(test-case "Atwood's machine: one coordinate agrees"
  (define (by-one local) (up (coordinate local) (- 'l (coordinate local))))
  (define x (literal-function 'x))
  (define (L-one local) ((L-Atwood 'm_1 'm_2 'g) ((F->C by-one) local)))
  (check-identity (((eliminate-multipliers (L-Atwood 'm_1 'm_2 'g) string-of-length by-one) x) 't)
                  (up (((Lagrange-equations L-one) x) 't) 0)))

;; ---------------------------------------------------------------------------
;; A mass on a vertical circle, polar coordinates from the top

(define ((L-top m g R) (up t (up r θ) (up vr vθ)))
  (+ (* 1/2 m (+ (square vr) (square (* r vθ)))) (* m g (- R (* r (cos θ))))))
(define on-circle (holonomic (lambda (t q) (- (ref q 0) 'R))))

(test-case "a mass on a circle: λ = m g cos θ − m r θ̇²"
  (define state (up 't (up 'R 'θ) (up 0 'v)))
  (check-identity ((constrained-accelerations (L-top 'm 'g 'R) on-circle) state)
                  (up (up 0 (/ (* 'g (sin 'θ)) 'R))
                      (- (* 'm 'g (cos 'θ)) (* 'm 'R (square 'v)))))
  (check-identity ((constraint-forces (L-top 'm 'g 'R) on-circle) state)
                  (down (- (* 'm 'g (cos 'θ)) (* 'm 'R (square 'v))) 0)))

(test-case "a mass on a circle: the angle alone agrees"
  (define (by-angle local) (up 'R (coordinate local)))
  (define θ (literal-function 'θ))
  (define (L-angle local) ((L-top 'm 'g 'R) ((F->C by-angle) local)))
  (check-identity (((eliminate-multipliers (L-top 'm 'g 'R) on-circle by-angle) θ) 't)
                  (up (((Lagrange-equations L-angle) θ) 't) 0)))

;; ---------------------------------------------------------------------------
;; Several constraints, moving ones, without inertia

(test-case "several constraints: one by one, or in a tuple"
  (define ((L-space m g) (up t q v)) (- (* 1/2 m (square v)) (* m g (ref q 2))))
  (define (plane t q) (ref q 0))
  (define (sphere t q) (- (sqrt (square q)) 'l))
  (define state (up 't (up 0 'y 'z) (up 0 'vy 'vz)))
  (define (solve constraints) ((constrained-accelerations (L-space 'm 'g) constraints) state))
  (define listed (solve (list (holonomic plane) (holonomic sphere))))
  (check-identity listed (solve (up (holonomic plane) (holonomic sphere))))
  (check-identity listed (solve (holonomic (lambda (t q) (up (plane t q) (sphere t q))))))
  (check-identity (ref listed 0 0) 0)
  (check-identity (ref listed 1 0) 0))

(test-case "a constraint that moves: a bead on a rod turned steadily"
  (define (turning t q) (- (* (ref q 1) (cos (* 'Ω t))) (* (ref q 0) (sin (* 'Ω t)))))
  (define (along local)
    (define-values (t r) (values (time local) (coordinate local)))
    (up (* r (cos (* 'Ω t))) (* r (sin (* 'Ω t)))))
  (define a ((constrained-accelerations (L-free-particle 'm) (holonomic turning))
             ((F->C along) (up 't 'r 'v))))
  ;; Coriolis's force, 2 m Ω v, is that of the rod
  (check-identity (ref a 1) (* 2 'm 'Ω 'v))
  (check-identity (((eliminate-multipliers (L-free-particle 'm) (holonomic turning) along)
                    (literal-function 'r)) 't)
                  (up (* 'm (- (((expt D 2) (literal-function 'r)) 't)
                               (* (square 'Ω) ((literal-function 'r) 't))))
                      0)))

(test-case "one coordinate, a number: its constraint and multiplier are numbers too"
  (define lift (holonomic (lambda (t x) (- x (* 1/2 'a (square t))))))
  (check-identity ((constrained-accelerations (L-free-particle 'm) lift) (up 't 'x 'v))
                  (up 'a (* 'm 'a)))
  (check-identity ((constraint-forces (L-free-particle 'm) lift) (up 't 'x 'v)) (* 'm 'a)))

(test-case "a coordinate without inertia is led by its constraint"
  (define (L (up t (up x y) (up vx vy))) (- (* 1/2 'm (square vx)) (* 'k y)))
  (define slope (holonomic (lambda (t q) (- (ref q 1) (* 'c (ref q 0))))))
  (check-identity ((constrained-accelerations L slope) (up 't (up 'x 'y) (up 'vx 'vy)))
                  (up (up (/ (* -1 'c 'k) 'm) (/ (* -1 (square 'c) 'k) 'm)) 'k)))

(test-case "masses that depend on each other"
  ;; two links, the second's end on a line: rank and signs by Lagrange's equations themselves
  (define (L (up t (up a b) (up va vb)))
    (+ (* 1/2 'm (+ (square va) (square vb) (* 'c va vb (cos (- a b))))) (* 'w (cos a))))
  (define line (holonomic (lambda (t q) (+ (sin (ref q 0)) (sin (ref q 1))))))
  (define state (up 't (up 'a 'b) (up 'va 'vb)))
  (define solution ((constrained-accelerations L line) state))
  (define force ((constraint-forces L line) state))
  (check-identity ((Euler-Lagrange-operator L) (up 't (up 'a 'b) (up 'va 'vb) (ref solution 0)))
                  force))
