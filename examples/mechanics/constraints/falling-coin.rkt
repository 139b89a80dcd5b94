#lang mechanics
;; A coin rolls on a table, leans, and goes round
;;
;; A thin disk of mass m and radius R touches the table at (x, y) and heads in the
;; direction φ; its plane makes the angle θ with the table, and ψ is the angle through
;; which it has rolled.  Five coordinates, all of them needed; rolling makes two
;; constraints on their velocities.

(require mechanics/plot)
(provide picture)

;; Its centre; and its angular velocity about the line it heads in, about the steepest
;; line in its plane, and about its axis.
(define ((centre R) (up t (up x y φ θ ψ) v))
  (up (- x (* R (cos θ) (sin φ))) (+ y (* R (cos θ) (cos φ))) (* R (sin θ))))
(define (turning (up t (up x y φ θ ψ) (up vx vy vφ vθ vψ)))
  (up vθ (* vφ (sin θ)) (- vψ (* vφ (cos θ)))))

(define ((L-coin m R g) local)
  (let ([at ((F->C (centre R)) local)] [ω (turning local)])
    (- (+ (* 1/2 m (square (velocity at)))
          (* 1/8 m (square R) (+ (square (ref ω 0)) (square (ref ω 1)) (* 2 (square (ref ω 2))))))
       (* m g (ref (coordinate at) 2)))))

(define ((slip R) t (up x y φ θ ψ) (up vx vy vφ vθ vψ))
  (up (- vx (* R vψ (cos φ))) (- vy (* R vψ (sin φ)))))
(define (rolling R) (nonholonomic (slip R)))
(Frobenius-test (rolling 'R) (up 'x 'y 'φ 'θ 'ψ))

;; Leaning at α it goes round a circle, at the angular velocity Ω.  How fast does it roll?
(define ((round rolls) t)
  (up (* 'R (/ rolls 'Ω) (sin (* 'Ω t)))
      (* -1 'R (/ rolls 'Ω) (cos (* 'Ω t)))
      (* 'Ω t)
      'α
      (* rolls t)))
(define (verdict-on rolls)
  (verify-solution (L-coin 'm 'R 'g) (round rolls) #:constraints (rolling 'R)))
(verdict-on 's)

;; The condition, solved for the rate of rolling.
(define steady
  (/ (* (cos 'α) (+ (* 5 (square 'Ω) (sin 'α)) (* 4 (/ 'g 'R))))
     (* 6 'Ω (sin 'α))))
(verdict-on steady)

;; A rider on a bicycle leans so that the slope is the centrifugal force over the weight,
;; cot α = ρ Ω²/g, where ρ is the distance of the centre from the axis.  A coin does not:
;; it takes a force to turn what spins.
(define like-a-bicycle (+ (/ (/ 'g 'R) (* 'Ω (tan 'α))) (* 'Ω (cos 'α))))
(verdict-on like-a-bicycle)

;; In numbers, with m, R and g equal to 1.
(define (roll state duration)
  (evolve-trajectory (constrained-state-derivative (L-coin 1 1 1) (rolling 1))
                     state duration #:tolerance 1e-11))

;; Rolled too slowly to stay upright it falls to one side, which turns it, which raises it
;; again.
(define swaying (roll (up 0. (up 0. 0. 0. 1.4 0.) (up 0.3 0. 0. 0. 0.3)) 60.))

(define (part k) (lambda (state) (ref (coordinate state) k)))
(define picture
  (frame -2.5 2.5 -2.5 2.5 #:aspect-ratio 'equal #:x-label "x" #:y-label "y"))
(plot-trajectory picture swaying (part 0) (part 1))
picture

(module+ main
  (require "../figures/save.rkt")
  (save-figure picture "falling-coin.png"))

(module+ test
  (require rackunit)
  (define (status rolls) (verdict-status (verdict-on rolls)))
  (test-case "round a circle: one rate of rolling, and not that of a point on a rod"
    (check-eq? (status 's) 'refuted)
    (check-eq? (status steady) 'proved)
    (check-eq? (status like-a-bicycle) 'refuted))
  (test-case "straight on it rolls upright, at any rate"
    (define (straight t) (up (* 'R 's t (cos 'β)) (* 'R 's t (sin 'β)) 'β 'α (* 's t)))
    (define verdict
      (verify-solution (L-coin 'm 'R 'g) straight #:constraints (rolling 'R)))
    (check-eq? (verdict-status verdict) 'refuted)
    (check-eq? (verdict-status (prove-zero (substitute (verdict-residual verdict) (cos 'α) 0)))
               'proved))
  (test-case "a rate of rolling above √(g/3R) keeps it upright, one below does not"
    ;; s² = g/3R is where A m g R = C (C + m R²) s², with the moments of inertia A about a
    ;; diameter and C about the axis
    (define (furthest s lean)
      (define rolled (roll (up 0. (up 0. 0. 0. (+ :pi/2 lean) 0.) (up s 0. 0. 0. s)) 20.))
      (apply max (for/list ([t (in-range 0. 20. 0.25)])
                   (abs (- (ref (coordinate (rolled t)) 3) :pi/2)))))
    ;; above, ten times less is ten times less; below, it leans as far
    (check-= (/ (furthest 0.65 1e-3) (furthest 0.65 1e-4)) 10 0.1)
    (check-= (/ (furthest 0.5 1e-3) (furthest 0.5 1e-4)) 1 0.1))
  (test-case "it rolls without slipping, and keeps its energy"
    (define energy (Lagrangian->energy (L-coin 1 1 1)))
    (for ([t (in-range 0. 60. 5.)])
      (define state (swaying t))
      (for ([x ((slip 1) t (coordinate state) (velocity state))]) (check-= x 0 1e-13))
      (check-= (energy state) (energy (swaying 0.)) 1e-8)))
  (test-case "the steady motion in numbers: back at the start after one turn"
    (define-values (Ω α) (values 1.2 1.1))
    (define s (substitute steady 'Ω Ω 'α α 'g 1 'R 1))
    (define round (roll (up 0. (up 0. (/ s Ω -1) 0. α 0.) (up s 0. Ω 0. s)) (/ :2pi Ω)))
    (define there (coordinate (trajectory-final-state round)))
    (for ([k 4] [expected (list 0. (/ s Ω -1) :2pi α)])
      (check-= (ref there k) expected 1e-8))))
