#lang mechanics
;; A ladder slides down a wall, and leaves it
;;
;; A uniform ladder of length l leans on a smooth wall and stands on a smooth floor, at an
;; angle θ with the floor.  Its centre and the angle are the coordinates; that its ends
;; keep to wall and floor are two constraints, whose multipliers are the forces of wall and
;; floor on it.  They can push and not pull.

(require mechanics/plot)
(provide picture)

(define ((L-ladder m l g) (up t (up x y θ) (up vx vy vθ)))
  (- (+ (* 1/2 m (+ (square vx) (square vy)))
        (* 1/24 m (square (* l vθ))))
     (* m g y)))
(define (wall l) (holonomic (lambda (t (up x y θ)) (- x (* 1/2 l (cos θ))))))
(define (floor l) (holonomic (lambda (t (up x y θ)) (- y (* 1/2 l (sin θ))))))

;; Where the ladder is when it keeps to both, by its angle.
(define ((leaning l) (up t θ vθ))
  (up (* 1/2 l (cos θ)) (* 1/2 l (sin θ)) θ))

;; Released at rest at the angle θ₀, it has the rate at θ that keeps its energy.
(define (state-at angle rate) ((F->C (leaning 'l)) (up 't angle rate)))
(define rate (sqrt (* 3 (/ 'g 'l) (- (sin 'θ_0) (sin 'θ)))))
(define energy (Lagrangian->energy (L-ladder 'm 'l 'g)))
(verify-equal (energy (state-at 'θ rate)) (energy (state-at 'θ_0 0)))

(define forces
  (ref ((constrained-accelerations (L-ladder 'm 'l 'g) (list (wall 'l) (floor 'l)))
        (state-at 'θ rate))
       1))
(define force-of-wall (ref forces 0))
(define force-of-floor (ref forces 1))

;; The wall's force vanishes where the upper end is at two thirds of its first height.
(verify-equal force-of-wall
              (* 3/4 'm 'g (cos 'θ) (- (* 3 (sin 'θ)) (* 2 (sin 'θ_0)))))

;; The floor's force never does: it is a sum of squares.
(verify-equal force-of-floor
              (* 1/4 'm 'g (+ (square (cos 'θ_0)) (square (- (* 3 (sin 'θ)) (sin 'θ_0))))))

;; Does the floor carry the weight all the time?
(verify-equal force-of-floor (* 'm 'g))

;; In numbers: down the wall to the event, and then with the floor alone.
(define (slide constraints state end)
  (evolve-trajectory (constrained-state-derivative (L-ladder 1 1 9.8) constraints)
                     state 10. #:events end #:tolerance 1e-12))

(define leaves-the-wall
  (let ([force (constraint-forces (L-ladder 1 1 9.8) (list (wall 1) (floor 1)))])
    (event (lambda (state) (ref (force state) 0))
           #:name 'leaves-the-wall #:direction 'falling #:terminal? #t)))
(define lies-down
  (event (lambda (state) (ref (coordinate state) 2)) #:name 'lies-down #:terminal? #t))

(define start-angle 1.4)
(define on-the-wall
  (slide (list (wall 1) (floor 1)) ((F->C (leaning 1)) (up 0. start-angle 0.))
         leaves-the-wall))
(define on-the-floor
  (slide (list (floor 1)) (trajectory-final-state on-the-wall) lies-down))

(define (height-of-end state) (sin (ref (coordinate state) 2)))
(/ (height-of-end (trajectory-final-state on-the-wall)) (sin start-angle))

(define picture
  (frame 0. 1.2 0. 1. #:width 500 #:height 420 #:aspect-ratio 'equal
         #:x-label "x" #:y-label "y"))
(define (draw-ladder state color)
  (let* ([q (coordinate state)]
         [half (* 1/2 (up (cos (ref q 2)) (- (sin (ref q 2)))))]
         [top (- (up (ref q 0) (ref q 1)) half)]
         [foot (+ (up (ref q 0) (ref q 1)) half)])
    (plot-line picture (ref top 0) (ref top 1) (ref foot 0) (ref foot 1) #:color color)))
(define (draw-slide slide color step)
  (for ([t (in-range (trajectory-start slide) (trajectory-end slide) step)])
    (draw-ladder (slide t) color)))
(draw-slide on-the-wall 'blue 0.04)
(draw-slide on-the-floor 'red 0.04)
picture

(module+ main
  (require "../figures/save.rkt")
  (save-figure picture "sliding-ladder.png"))

(module+ test
  (require rackunit)
  (define-syntax-rule (check-status status verdict)
    (check-eq? (verdict-status verdict) status))
  (test-case "the forces of wall and floor"
    (check-status 'proved
                  (verify-equal force-of-wall
                                (* 3/4 'm 'g (cos 'θ)
                                   (- (* 3 (sin 'θ)) (* 2 (sin 'θ_0))))))
    (check-status 'proved
                  (verify-equal force-of-floor
                                (* 1/4 'm 'g (+ 1 (* 9 (square (sin 'θ)))
                                                (* -6 (sin 'θ) (sin 'θ_0))))))
    (check-status 'refuted (verify-equal force-of-floor (* 'm 'g))))
  (test-case "it leaves the wall at two thirds of the height"
    (check-= (height-of-end (trajectory-final-state on-the-wall))
             (* 2/3 (sin start-angle)) 1e-9))
  (test-case "then its centre goes on at the speed it has, and energy is kept"
    (define energy (Lagrangian->energy (L-ladder 1 1 9.8)))
    (define-values (left last) (values (trajectory-final-state on-the-wall)
                                       (trajectory-final-state on-the-floor)))
    (check-= (ref (velocity last) 0) (ref (velocity left) 0) 1e-10)
    (check-= (ref (velocity left) 0) (* 1/3 (sqrt (* 9.8 (expt (sin start-angle) 3)))) 1e-9)
    (check-= (energy last) (* 1/2 9.8 (sin start-angle)) 1e-9)
    (check-= (ref (coordinate last) 1) 0 1e-10))
  (test-case "the picture shows ladders, all of one length"
    (for ([ends (frame-curves picture)])
      (check-= (square (- (vector->up (car ends)) (vector->up (cadr ends)))) 1 1e-9))))
