#lang mechanics
;; A roller coaster: how hard does the track press, and where does the car leave it?
;;
;; A car without friction, on a track that can push and not pull: the track's force is the
;; multiplier of the constraint that the car is on it.

(require mechanics/plot)
(provide picture)

(define ((L-car m g) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (* m g y)))

;; A track of any shape, y = f(x).  The multiplier is the vertical part of its force.
(define f (literal-function 'f))
(define track (holonomic (lambda (t (up x y)) (- y (f x)))))
(define on-track ((F->C (lambda (local) (up (coordinate local) (f (coordinate local)))))
                  (up 't 'x 'vx)))
(define push (ref ((constrained-accelerations (L-car 'm 'g) track) on-track) 1))
push

;; Over the top of a hill, where the slope is zero, it pushes with the weight less m v²
;; over the radius of curvature.
(verify-equal (substitute push ((D f) 'x) 0)
              (* 'm (+ 'g (* (((expt D 2) f) 'x) (square 'vx)))))

;; A loop of radius R.  Polar coordinates from its centre, θ from its lowest point; the
;; force of the track is minus the multiplier.
(define ((L-loop m g) (up t (up r θ) (up vr vθ)))
  (+ (* 1/2 m (+ (square vr) (square (* r vθ)))) (* m g r (cos θ))))
(define (loop R) (holonomic (lambda (t (up r θ)) (- r R))))

;; The car comes from the height h above the lowest point, and was at rest there.
(define rate (sqrt (* 2 'g (- 'h (* 'R (- 1 (cos 'θ)))) (/ (square 'R)))))
(define force
  (* -1 (ref ((constrained-accelerations (L-loop 'm 'g) (loop 'R))
              (up 't (up 'R 'θ) (up 0 rate)))
             1)))
force

;; It is nowhere less than at the top.  Is it enough to start as high as the top is?
(define (force-at-top h) (substitute force (cos 'θ) -1 'h h))
(prove-zero (force-at-top (* 2 'R)))
(prove-zero (force-at-top (* 5/2 'R)))

;; From lower down it leaves where cos θ = 2/3 (1 - h/R).
(verify-equal force (* 3 'm 'g (- (cos 'θ) (* 2/3 (- 1 (/ 'h 'R))))))

;; In numbers, with m, g and R equal to 1: from the lowest point round the loop or to
;; where it leaves it, and from there on in free flight until it comes back to the track.
(define leaves
  (let ([force (constraint-forces (L-loop 1 1) (loop 1))])
    (event (lambda (state) (ref (force state) 0))
           #:name 'leaves #:direction 'rising #:terminal? #t)))
(define round-once
  (event (lambda (state) (- (ref (coordinate state) 1) :2pi))
         #:name 'round-once #:terminal? #t))
(define (ride h)
  (evolve-trajectory (constrained-state-derivative (L-loop 1 1) (loop 1))
                     (up 0. (up 1. 0.) (up 0. (sqrt (* 2. h)))) 20.
                     #:events (list leaves round-once) #:tolerance 1e-12))

(define back-on-track
  (event (lambda (state) (- (square (coordinate state)) 1))
         #:name 'back-on-track #:direction 'rising #:terminal? #t))
(define rectangular
  (F->C (lambda (local)
          (let ([r (ref (coordinate local) 0)] [θ (ref (coordinate local) 1)])
            (up (* r (sin θ)) (* -1 r (cos θ)))))))
(define (flight ride)
  (evolve-trajectory (Lagrangian->state-derivative (L-car 1 1))
                     (rectangular (trajectory-final-state ride)) 20.
                     #:events back-on-track #:tolerance 1e-12))

(define low (ride 2.2))
(define high (ride 2.6))
(map occurrence-event (trajectory-events low))
(map occurrence-event (trajectory-events high))

(define picture
  (frame -1.2 1.2 -1.2 1.7 #:height 450 #:aspect-ratio 'equal #:x-label "x" #:y-label "y"))
(define (x state) (ref (coordinate state) 0))
(define (y state) (ref (coordinate state) 1))
(plot-trajectory picture high (compose x rectangular) (compose y rectangular)
                 #:style 'dot #:label "from 2.6 R")
(plot-trajectory picture low (compose x rectangular) (compose y rectangular)
                 #:color 'blue #:width 2 #:label "from 2.2 R")
(plot-trajectory picture (flight low) x y #:color 'red #:width 2)
picture

(module+ main
  (require "../figures/save.rkt")
  (save-figure picture "roller-coaster.png"))

(module+ test
  (require rackunit)
  (define-syntax-rule (check-status status verdict)
    (check-eq? (verdict-status verdict) status))
  (define (event-of ride) (occurrence-event (car (trajectory-events ride))))
  (test-case "the force of a track of any shape is normal to it"
    (define forces ((constraint-forces (L-car 'm 'g) track) on-track))
    (check-status 'proved (prove-zero (+ (ref forces 0) (* ((D f) 'x) (ref forces 1)))))
    (check-status 'proved (verify-equal (ref forces 1) push))
    (check-status 'refuted
                  (verify-equal (substitute push ((D f) 'x) 0) (* 'm 'g))))
  (test-case "round the loop from 5/2 R, and not from 2 R"
    (check-status 'proved (prove-zero (force-at-top (* 5/2 'R))))
    (check-status 'refuted (prove-zero (force-at-top (* 2 'R))))
    (check-status 'proved (verify-equal (force-at-top (* 2 'R)) (* -1 'm 'g)))
    (check-eq? (event-of low) leaves)
    (check-eq? (event-of high) round-once)
    (check-eq? (event-of (ride 2.501)) round-once)
    (check-eq? (event-of (ride 2.499)) leaves))
  (test-case "where it leaves"
    (check-= (cos (ref (coordinate (trajectory-final-state low)) 1)) (* 2/3 (- 1 2.2)) 1e-9))
  (test-case "from below the height of the centre it swings, and stays on the track"
    (check-equal? (trajectory-events (ride 0.9)) '()))
  (test-case "in flight it keeps its energy, inside of the loop"
    (define energy (Lagrangian->energy (L-car 1 1)))
    (define free (flight low))
    (check-= (energy (trajectory-final-state free)) (- 2.2 1) 1e-9)
    (check-= (square (coordinate (trajectory-final-state free))) 1 1e-9)
    (for ([t (in-range (+ 0.05 (trajectory-start free)) (- (trajectory-end free) 0.05) 0.05)])
      (check-true (< (square (coordinate (free t))) 1)))))
