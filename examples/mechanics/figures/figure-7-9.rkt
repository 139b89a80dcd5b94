#lang mechanics
;; Section of a perturbative solution  (SICM 7.4.1, Figure 7.9)
;;
;; The driven pendulum near the resonance ω: its motion by the theory of the first order, looked at
;; once in each period of the drive, α = β = 1, γ = 1/4, ω = 5.  By itself the resonance Hamiltonian
;; has an island as high above its middle as below; the transform that removes the other waves bends
;; it.

(require mechanics/plot "resonances.rkt")

(define gamma 1/4)
(define k '(-1 1))

(define picture (frame :-pi :pi 2.5 7.5 #:width 400 #:height 400 #:x-label "θ" #:y-label "p"))
(draw-theory picture gamma k
             '((3.1 5.) (3.1 5.2) (3.1 5.4) (3.1 5.6) (3.1 5.75) (3.1 5.84)
               (0. 3.2) (0. 3.8) (0. 4.2) (0. 5.8) (0. 6.3) (0. 6.8))
             150)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-9.png"))

(module+ test
  (require rackunit)
  (define-values (low high) (apply values (edges gamma k)))
  (define-values (really-low really-high) (apply values (island-edges gamma k pi 5.)))
  (test-case "the island reaches as far as that of the pendulum itself, to 0.005 of 2"
    (check-= low really-low 0.005)
    (check-= high really-high 0.005)
    (check-= (- high low) (* 2 (half-width gamma k)) 0.1))
  (test-case "it is not symmetrical about the middle of the resonance, by far more than that"
    (check-true (> (- (- 5 low) (- high 5)) 0.3)))
  (test-case "one period of the theory and one of the pendulum"
    (define T (driven-map gamma))
    (define motion ((resonant-motion gamma k) 3. 5.2))
    (define there (motion (/ :2pi omega)))
    (define image (T 3. 5.2 up void))
    (check-= (ref there 0) (ref image 0) 0.01)
    (check-= (ref there 1) (ref image 1) 0.01))
  (test-case "in the new variables an orbit keeps its energy, so its points lie on a curve"
    (define motion ((resonant-motion gamma k) 3.1 5.6))
    (define ps (for/list ([j 150]) (ref (motion (/ (* j :2pi) omega)) 1)))
    (check-true (< low (apply min ps)))
    (check-true (> high (apply max ps)))))
