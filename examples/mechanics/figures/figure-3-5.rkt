#lang mechanics
;; The effective potential of an upright top  (SICM 3.4, Figure 3.5)
;;
;; With p = p_φ = p_ψ above, at and below the critical value: the place of rest at θ = 0 becomes
;; three, the middle one unstable.

(require mechanics/plot)

(define-values (A C gMR) (values 6.96e-4 1.32e-4 0.112))
(define p_c (* C (critical-spin A C gMR)))
;; Without the constant p²/2C, which is another for each curve.
(define (V p) (let ([U (V_eff p A C gMR)]) (lambda (theta) (- (U theta) (/ (square p) (* 2 C))))))

(define picture
  (frame -1.2 1.2 0.1 0.14 #:width 450 #:height 350 #:x-label "θ" #:y-label "V"))
(for ([share '(1.1 1. 0.9)] [color '(blue black red)])
  (plot-function picture (V (* share p_c)) -1.2 1.2 #:color color
                 #:label (format "p = ~a p_c" share)))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-3-5.png"))

(module+ test
  (require rackunit)
  (define (curvature share) (((expt D 2) (V (* share p_c))) 0.))
  (test-case "upright the curvature changes its sign at p_c"
    (check-true (> (curvature 1.1) 0))
    (check-= (curvature 1.) 0 1e-12)
    (check-true (< (curvature 0.9) 0)))
  (test-case "below it there are two other places of rest, one on each side"
    (define low (V (* 0.9 p_c)))
    (define tilt (car (minimize low 0.1 1.2)))
    (check-= ((D low) tilt) 0 1e-8)
    (check-= ((D low) (- tilt)) 0 1e-8)
    (check-true (< (low tilt) (low 0.)))))
