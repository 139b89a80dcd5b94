#lang mechanics
;; Two double pendulums that start almost alike  (SICM 1.7, exercise 1.44)
;;
;; They are released with the upper bar level and the lower one pointing up, one of them
;; with its lower bob 10⁻¹⁰ m aside.  The logarithm of the distance between the two lower
;; bobs grows like time: the distance grows exponentially until it is as large as the
;; pendulums.

(require mechanics/plot)

(define-values (l1 l2 m1 m2 g) (values 1. 0.9 1. 3. 9.8))

(define (L-rectangular local)
  (let ([q (coordinate local)] [v (velocity local)])
    (- (+ (* 1/2 m1 (square (ref v 0))) (* 1/2 m2 (square (ref v 1))))
       (+ (* m1 g (ref q 0 1)) (* m2 g (ref q 1 1))))))

;; Angles from the vertical -> positions of the bobs.
(define (bobs local)
  (let* ([angles (coordinate local)]
         [bar (lambda (l angle) (up (* l (sin angle)) (- (* l (cos angle)))))]
         [first-bob (bar l1 (ref angles 0))])
    (up first-bob (+ first-bob (bar l2 (ref angles 1))))))

(define swing
  (let ([derivative (Lagrangian->state-derivative (compose L-rectangular (F->C bobs)))])
    (lambda (angles)
      (evolve-trajectory derivative (up 0. angles (up 0. 0.)) 50. #:tolerance 1e-13))))

(define one (swing (up :pi/2 :pi)))
(define other (swing (up :pi/2 (+ :pi (/ 1e-10 l2)))))

(define (lower-bob trajectory) (lambda (t) (ref (bobs (trajectory t)) 1)))

(define (log-distance t)
  (let ([d (- ((lower-bob one) t) ((lower-bob other) t))])
    (/ (log (sqrt (square d))) (log 10))))

(define picture
  (frame 0. 50. -12. 2. #:width 600 #:height 300
         #:x-label "t" #:y-label "log₁₀ of the distance"))

(plot-function picture log-distance 0. 50. 0.05)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "exercise-1-44.png"))

(module+ test
  (require rackunit)
  (test-case "the motion after 1 second"
    (for ([x (coordinate (one 1.))] [expected (list .0910630038849611 -1.66626245247204)])
      (check-= x expected 1e-9)))
  (test-case "the distance is that at the start, and in the end that of the pendulums"
    (check-= (log-distance 0.) -10 1e-5)
    (check-true (< -1 (apply max (map (lambda (p) (ref p 1)) (car (frame-curves picture)))) 1))))
