#lang mechanics
;; A bead on a ring of radius 1 that turns about its vertical diameter, once more by numbers: the
;; bottom gives up its stability where the square of the rate is g, and two equilibria leave it.

(require mechanics/plot)

(define g 9.8)
(define ((L-bead Omega) (up t theta thetadot))
  (+ (* 1/2 (square thetadot))
     (* 1/2 (square Omega) (square (sin theta)))
     (* g (cos theta))))
(define (bead Omega) (Lagrangian->state-derivative (L-bead Omega)))

(define bottom (continue-equilibrium bead (up 0 0.1 0) 1 6))
bottom
(define fork (car (branch-special-points bottom)))
(define sides
  (for/list ([side '(1 -1)]) (switch-branch bottom fork #:direction side)))

(define diagram (frame 1 6 -1.6 1.6 #:x-label "Ω" #:y-label "θ"))
(for ([b (cons bottom sides)] [color '(black red red)])
  (plot-branch diagram b coordinate #:color color))
diagram

(module+ test
  (require rackunit)
  (test-case "the pitchfork is where the formula has it"
    (check-eq? (special-point-kind fork) 'pitchfork)
    (check-= (special-point-parameter fork) (sqrt g) 1e-10))
  (test-case "and so are the equilibria that leave it"
    (for* ([b sides] [(Omega state) (in-parallel (branch-parameters b) (branch-states b))])
      (check-= (* (square Omega) (cos (coordinate state))) g 1e-7))))
