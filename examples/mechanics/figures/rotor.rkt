#lang mechanics
;; Solutions of the pendulum as a perturbed rotor, α = 1, β = 0.1 and ε = 1, in the phase plane, for
;; the figures of section 7.2.
;;
;; A motion is a function of the time whose values are states.  It is drawn from where the
;; pendulum points up at θ = −π to where it does so at θ = π, which is half a turn before and after
;; the state that it is about.

(require mechanics/plot mechanics/book)

(provide alpha beta start first-step truth
         plane draw-turn draw-points state-at turn-time)

(define-values (alpha beta) (values 1. 0.1))

;; p in the middle of a turn; the separatrix is at 2 √(αβ) = 0.632.
(define (start p) (up 0. 0. p))

;; The book's solution with one step of perturbation theory, terms of Lie series up to an order
(define ((first-step order) state)
  (lambda (t) ((((solution 1 order) alpha beta) t) state)))

;; The pendulum, by elliptic functions
(define truth (pendulum-advance alpha beta))

;; ---------------------------------------------------------------------------
;; Where a motion is

;; The state in which a motion that turns has the angle θ, counted without end
(define (state-at motion theta)
  (define rate (/ (- (coordinate (motion 1.)) (coordinate (motion -1.))) 2.))
  (motion (find-root (lambda (t) (- (coordinate (motion t)) theta)) (/ theta rate))))

(define (turn-time motion)
  (- (time (state-at motion pi)) (time (state-at motion :-pi))))

;; ---------------------------------------------------------------------------
;; Pictures

(define (plane low high)
  (frame :-pi :pi low high #:width 400 #:height 300 #:x-label "θ" #:y-label "p"))

(define (draw-turn picture motion #:color [color 'black] #:duration [T (turn-time motion)])
  (plot-parametric picture
                   (lambda (t) (up (coordinate (motion t)) (momentum (motion t))))
                   (* -1/2 T) (* 1/2 T) (/ T 200)
                   #:color color))

;; A point for each step of a longer time
(define (draw-points picture motion duration step #:color [color 'black])
  (for ([t (in-range 0. duration step)])
    (define s (motion t))
    (plot-point picture ((principal-value :pi) (coordinate s)) (momentum s) #:color color)))
