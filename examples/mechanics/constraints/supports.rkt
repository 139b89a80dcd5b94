#lang mechanics
;; A mass on a vertical circle: on a ball, on a string, on a wire. Polar coordinates, θ from
;; the top; the constraint's force is m g cos θ − m r θ̇² outwards. A ball only pushes, a
;; string only pulls, a wire does both.

(define ((L-circle m g R) (up t (up r θ) (up vr vθ)))
  (+ (* 1/2 m (+ (square vr) (square (* r vθ)))) (* m g (- R (* r (cos θ))))))
(define ((circle R) t (up r θ)) (- r R))

(define force
  (ref ((constraint-forces (L-circle 'm 'g 'R) (holonomic (circle 'R)))
        (up 't (up 'R 'θ) (up 0 'ω)))
       0))
force

;; When does a support fail, for a start at θ with angular velocity ω?
(define g 9.8)
(define L (L-circle 1 g 1))
(define kept (holonomic (circle 1)))
(define along (constrained-state-derivative L kept))
(define (first-failure support θ ω)
  (define outwards (constraint-forces L kept))
  (define fails
    (event (lambda (state) (ref (outwards state) 0)) #:name support #:terminal? #t
           #:direction (case support [(ball) 'falling] [(string) 'rising])))
  (define tr
    (evolve-trajectory along (up 0 (up 1 θ) (up 0 ω)) 20 #:tolerance 1e-12 #:events fails))
  (and (pair? (trajectory-events tr)) (trajectory-final-state tr)))
(define (tell support state)
  (if state
      (printf "~a fails at ~a s, θ = ~a\n" support (time state) (ref (coordinate state) 1))
      (printf "~a never fails\n" support)))

(define off-the-ball (first-failure 'ball 1e-6 0))          ; from rest at the top
(tell 'ball off-the-ball)
(define slack (first-failure 'string :pi (sqrt (* 3.5 g)))) ; pushed at the bottom
(tell 'string slack)
(tell 'string (first-failure 'string :pi (sqrt (* 5.01 g))))
(tell 'string (first-failure 'string :pi (sqrt (* 1.9 g))))

(module+ test
  (require rackunit)
  (test-case "the force of the constraint"
    (check-eq? (verdict-status
                (verify-equal force (- (* 'm 'g (cos 'θ)) (* 'm 'R (square 'ω)))))
               'proved))
  (test-case "a ball is left at cos θ = 2/3"
    (check-= (cos (ref (coordinate off-the-ball) 1)) 2/3 1e-10))
  (test-case "a string pushed with v² = 3.5 g l at the bottom goes slack at cos θ = 1/2"
    (check-= (cos (ref (coordinate slack) 1)) 1/2 1e-10))
  (test-case "a string holds for v² from 5 g l on, and up to 2 g l"
    (check-false (first-failure 'string :pi (sqrt (* 5.01 g))))
    (check-not-false (first-failure 'string :pi (sqrt (* 4.99 g))))
    (check-false (first-failure 'string :pi (sqrt (* 1.99 g))))
    (check-not-false (first-failure 'string :pi (sqrt (* 2.01 g))))))
