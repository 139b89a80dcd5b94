#lang mechanics
;; A bead on a ring that turns. It rests at the minima of its effective potential. Above the
;; critical rate of the ring the bottom is a maximum, and there are two places of rest beside it:
;; the bifurcation. The second picture has its orbits in the plane of angle and rate.

(require mechanics/plot)
(provide interaction orbits)

(define-values (g critical) (values 9.8 (sqrt 9.8)))        ; R = 1

(define ((L-ring omega) (up t angle rate))
  (+ (* 1/2 (square rate)) (* 1/2 (square (* omega (sin angle)))) (* g (cos angle))))

;; The energy where the rate is 0
(define ((potential omega) angle) ((Lagrangian->energy (L-ring omega)) (up 0 angle 0)))

(define (places-of-rest omega)
  (if (> omega critical)
      (let ([aside (acos (/ g (square omega)))]) (list (- aside) aside))
      (list 0)))

(define interaction
  (interact ([omega 0.0 8.0 #:start 2.0])
    (define f (frame -2 2 -25 0 #:x-label "angle" #:y-label "effective potential"))
    (plot-function f (potential omega) -2 2)
    (for ([angle (places-of-rest omega)])
      (plot-point f angle ((potential omega) angle) #:color 'red #:size 12))
    f))
interaction

(define orbits
  (interact ([omega 0.0 8.0 #:step 0.25 #:start 2.0])
    (define f (frame -3.2 3.2 -8 8 #:x-label "angle" #:y-label "rate"))
    (plot-phase-portrait f (Lagrangian->energy (L-ring omega)) #:orbits 8 #:samples 101)
    f))
orbits

(module+ test
  (require rackunit)
  (test-case "no force is left where it rests, and the potential is least"
    (for* ([omega '(1. 3. 3.2 5. 8.)] [angle (places-of-rest omega)])
      (check-= (((partial 1) (L-ring omega)) (up 0 angle 0)) 0 1e-12)
      (check-true (< ((potential omega) angle) ((potential omega) (+ angle 0.01))))
      (check-true (< ((potential omega) angle) ((potential omega) (- angle 0.01)))))))
