#lang mechanics
;; A sleigh on one blade (Chaplygin's)
;;
;; A plate slides on ice on a blade, which lets it move along its edge but not across, and
;; on two smooth feet.  The blade is at (x, y), its direction θ, and the centre of mass
;; lies ahead of it by a.  The constraint is on the velocities, and of no function of the
;; coordinates: none of them is lost.

(require mechanics/plot)
(provide picture)

(define (centre-of-mass a)
  (lambda (local)
    (let ([q (coordinate local)])
      (up (+ (ref q 0) (* a (cos (ref q 2)))) (+ (ref q 1) (* a (sin (ref q 2)))) (ref q 2)))))
(define ((L-plate m I) (up t (up x y θ) (up vx vy vθ)))
  (+ (* 1/2 m (+ (square vx) (square vy))) (* 1/2 I (square vθ))))
(define (L-sleigh m I a) (compose (L-plate m I) (F->C (centre-of-mass a))))
(define (slip t (up x y θ) (up vx vy vθ)) (- (* vy (cos θ)) (* vx (sin θ))))
(define blade (nonholonomic slip))
(Frobenius-test blade (up 'x 'y 'θ))

;; A state that the blade allows, by its speed u along the edge and its rate of turning ω.
(define (gliding u ω)
  (up 't (up 'x 'y 'θ) (up (* u (cos 'θ)) (* u (sin 'θ)) ω)))
(define accelerations
  (ref ((constrained-accelerations (L-sleigh 'm 'I 'a) blade) (gliding 'u 'ω)) 0))

;; u² is vx² + vy²; the rates of u and ω:
(define rate-of-speed
  (+ (* (cos 'θ) (ref accelerations 0)) (* (sin 'θ) (ref accelerations 1))))
(define rate-of-turning (ref accelerations 2))
(up rate-of-speed rate-of-turning)

;; The rate of a function f of the state: what the blade does is no work.
(define (rate f)
  (let ([state (gliding 'u 'ω)])
    (+ (* (((partial 1) f) state) (velocity state)) (* (((partial 2) f) state) accelerations))))
(prove-zero (rate (Lagrangian->energy (L-sleigh 'm 'I 'a))))

;; But the angular momentum about the blade is not conserved, though θ does not occur in
;; the energy: the blade pulls.
(prove-zero (rate (lambda (state)
                    (ref (((partial 2) (L-sleigh 'm 'I 'a)) state) 2))))

;; The turning dies out, and what was in it goes into the speed.
(define β (/ (* 'm 'a 'c) (+ 'I (* 'm (square 'a)))))
(define (speed t) (* 'c (tanh (* β t))))
(define (turning t) (/ (* 'c (sqrt (/ 'm (+ 'I (* 'm (square 'a)))))) (cosh (* β t))))
(define (along-it rate) (substitute rate 'u (speed 't) 'ω (turning 't)))
(assuming ('(> m 0) '(> I 0))
  (verify-equal (up ((D speed) 't) ((D turning) 't))
                (along-it (up rate-of-speed rate-of-turning))))

;; In numbers, with m, I and a equal to 1, from long before the time 0 to long after it.
(define glide
  (evolve-trajectory (constrained-state-derivative (L-sleigh 1 1 1) blade)
                     (up 0. (up 0. 0. 0.) (up -1.5 0. 0.05)) 12. #:tolerance 1e-12))

(define picture
  (frame -12. 2. -10. 1. #:height 340 #:aspect-ratio 'equal #:x-label "x" #:y-label "y"))
(plot-trajectory picture glide
                 (lambda (state) (ref (coordinate state) 0))
                 (lambda (state) (ref (coordinate state) 1)))
picture

(module+ main
  (require "../figures/save.rkt")
  (save-figure picture "Chaplygin-sleigh.png"))

(module+ test
  (require rackunit)
  (define-syntax-rule (check-status status verdict)
    (check-eq? (verdict-status verdict) status))
  (define (speed-of state)
    (let ([θ (ref (coordinate state) 2)])
      (+ (* (cos θ) (ref (velocity state) 0)) (* (sin θ) (ref (velocity state) 1)))))
  (define (turning-of state) (ref (velocity state) 2))
  (test-case "the blade allows all places"
    (check-status 'refuted (Frobenius-test blade (up 'x 'y 'θ))))
  (test-case "the rates of the speed and of the turning"
    (check-status 'proved (verify-equal rate-of-speed (* 'a (square 'ω))))
    (check-status 'proved
                  (verify-equal rate-of-turning
                                (/ (* -1 'm 'a 'u 'ω) (+ 'I (* 'm (square 'a)))))))
  (test-case "energy is conserved, angular momentum about the blade is not"
    (check-status 'proved (prove-zero (rate (Lagrangian->energy (L-sleigh 'm 'I 'a)))))
    (define (momentum state) (ref (((partial 2) (L-sleigh 'm 'I 'a)) state) 2))
    (check-status 'refuted (prove-zero (rate momentum))))
  (test-case "the motion in closed form, and one that turns too slowly"
    (define (status turning)
      (assuming ('(> m 0) '(> I 0))
        (verdict-status
         (verify-equal ((D speed) 't)
                       (substitute rate-of-speed 'u (speed 't) 'ω (turning 't))))))
    (check-eq? (status turning) 'proved)
    (check-eq? (status (* 1/2 turning)) 'refuted))
  (test-case "the numbers follow the closed form, and the blade does not slip"
    ;; with m = I = a = 1: c² = u² + 2 ω², ω has its peak c/√2 where u changes its sign
    (define c (sqrt (+ (square 1.5) (* 2 (square 0.05)))))
    (define middle (/ (* 2 (atanh (/ 1.5 c))) c))
    (for ([t (in-range 0. 12.)])
      (define s (glide t))
      (check-= (speed-of s) (* c (tanh (* 1/2 c (- t middle)))) 1e-9)
      (check-= (turning-of s) (/ c (sqrt 2) (cosh (* 1/2 c (- t middle)))) 1e-9)
      (check-= (slip t (coordinate s) (velocity s)) 0 1e-14)))
  (test-case "in the end it glides straight on"
    (check-true (< 0 (turning-of (glide 12.)) 0.02))))
