#lang mechanics
;; One motion in two phase planes  (SICM 3.5.1, Figure 3.10)
;;
;; The driven pendulum by L = T − V, and by the Lagrangian that reads its equation of motion, with
;; the momentum m l² Dθ.  They differ by a total time derivative: the motion is the same, its
;; momenta are not.  In blue the first, in black the second, for 30 seconds.

(require mechanics/plot mechanics/book)

(define-values (m l g A omega) (values 1. 1. 9.8 0.1 (* 2. (sqrt 9.8))))
(define L-first (L-periodically-driven-pendulum m l g A omega))
;; m l² θ̈ = −m l (g + ÿ) sin θ, with the height y = A cos ωt of the support
(define ((L-read m l g y) (up t theta thetadot))
  (+ (* 1/2 m (square (* l thetadot)))
     (* m l (+ g (((expt D 2) y) t)) (cos theta))))
(define L-second (L-read m l g (periodic-drive A omega 0.)))

(define (follow L)
  (evolve-trajectory (Hamiltonian->state-derivative (Lagrangian->Hamiltonian L))
                     (up 0. 1. 0.) 30. #:tolerance 1e-12))
(define-values (first second) (values (follow L-first) (follow L-second)))

(define picture
  (frame :-pi :pi -10. 10. #:width 450 #:height 450 #:x-label "θ" #:y-label "p_θ"))
(define (draw motion color)
  (for ([t (in-range 0. 30. 0.005)])
    (define s (motion t))
    (plot-point picture ((principal-value :pi) (coordinate s)) (momentum s) #:color color)))
(draw first 'blue)
(draw second 'black)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-3-10.png"))

(module+ test
  (require rackunit)
  (test-case "they differ by a total time derivative"
    (define y (literal-function 'y))
    (define difference (- (L-pend 'm 'l 'g y) (L-read 'm 'l 'g y)))
    (check-pred proved? (verify-total-time-derivative difference (up 't 'theta 'thetadot))))
  (test-case "the motion is the same, and the momenta differ by that"
    (for ([t '(1. 3. 5.)])
      (define-values (a b) (values (first t) (second t)))
      (check-= (coordinate a) (coordinate b) 1e-7)
      (check-= (- (momentum a) (momentum b))
               (* -1 m l A omega (sin (* omega t)) (sin (coordinate a))) 1e-6))))
