#lang mechanics
;; Hyperion tumbles  (SICM 2.11.2, Figure 2.13)
;;
;; With ε = 0.89 on an orbit of the eccentricity 0.1 the angle to the planet's line, drawn on
;; one turn, now swings about one face, now about the other, and now goes round.

(require mechanics/plot "orbits.rkt")

(define hyperion (follow 0.89 0.1 1.05 50.))

(define picture
  (frame 0. 50. :-pi :pi #:width 600 #:height 300 #:x-label "orbits" #:y-label "θ − f"))
(for ([t (in-range 0. 50. 0.01)]) (plot-point picture t (on-a-turn (hyperion t))))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-2-13.png"))

(module+ test
  (require rackunit)
  (define angles (map (lambda (p) (ref p 1)) (frame-points picture)))
  (test-case "it shows all its sides"
    (for ([k 8])
      (define low (+ (- pi) (* k (/ pi 4))))
      (check-not-false (findf (lambda (a) (< low a (+ low (/ pi 4)))) angles))))
  (test-case "starts that differ by 1e-9 part exponentially"
    (define other
      (evolve-trajectory (spin-orbit-sysder orbit 0.89 0.1) (up 0. 1e-9 (* 1.05 orbit) 0.) 12.
                         #:tolerance 1e-12))
    (define (apart t) (abs (- (ref (hyperion t) 1) (ref (other t) 1))))
    (check-true (> (/ (apart 12.) 1e-9) (exp 6)))))
