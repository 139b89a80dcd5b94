#lang mechanics
;; The phase plane of a pendulum  (SICM 3.3, Figure 3.4)
;;
;; Motions are contours of the Hamiltonian: closed ones swing, wavy ones go round, the separatrix
;; in red is between them.

(require mechanics/plot mechanics/book)

;; kg, m, m/s²
(define-values (m l g) (values 1. 1. 9.8))
(define H (Lagrangian->Hamiltonian (L-pendulum g m l)))
(define (energy theta p) (H (up 0. theta p)))

(define picture
  (frame :-pi :pi -10. 10. #:width 450 #:height 400 #:x-label "θ" #:y-label "p_θ"))
(plot-contours picture energy (for/list ([theta '(0.5 1. 1.5 2. 2.5)]) (energy theta 0.))
               #:samples 151)
(plot-contours picture energy (for/list ([p '(7. 8. 9.)]) (energy 0. p)) #:samples 151)
(plot-contours picture energy (energy pi 0.) #:samples 151 #:color 'red)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-3-4.png"))

(module+ test
  (require rackunit)
  (define (last-angle start)
    (abs (ref ((state-advancer (lambda () (Hamiltonian->state-derivative H))) start 10. 1e-11) 1)))
  (test-case "the separatrix goes through the upright rest, as high as 2 m l √(g l)"
    (check-= (energy 0. (* 2 (sqrt g))) (energy pi 0.) 1e-13))
  (test-case "below it the pendulum swings, above it goes round"
    (check-true (< (last-angle (up 0. 0. (* 1.99 (sqrt g)))) pi))
    (check-true (> (last-angle (up 0. 0. (* 2.01 (sqrt g)))) pi)))
  (test-case "the Hamiltonian is conserved"
    (define symbolic (Lagrangian->Hamiltonian (L-pendulum 'g 'm 'l)))
    (check-pred proved? (verify-conserved symbolic symbolic (up 't 'theta 'p)))))
