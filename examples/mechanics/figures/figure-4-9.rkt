#lang mechanics
;; The homoclinic tangle of the driven pendulum  (SICM 4.3.1, Figure 4.9)
;;
;; A = 0.05 m, ω = 4.2 ω₀: from the pendulum upside down the unstable manifold, red, and the stable
;; one, blue, which without a drive are one separatrix. They cross without end, in excursions ever
;; longer and thinner.  Gray, the section: regular orbits in the middle, and a chaotic zone.

(require mechanics/plot "strobe.rkt")

(define-values (forwards backwards) (values (strobe-map 0.05 4.2) (strobe-map 0.05 -4.2)))

(define win (frame :-pi :pi -9. 9. #:width 500 #:height 450 #:x-label "θ" #:y-label "p_θ"))
(for ([start '((1. 0.) (1.5 0.) (1.9 0.) (3.1 0.))])
  (for/fold ([theta (car start)] [p (cadr start)]) ([k 500])
    (plot-point win theta p #:color 'gray)
    (forwards theta p values void)))
(define (branch T side)
  (fixed-point-eigen T :pi 0. 1e-8
                     (lambda (rho dx dy rho-2 dx-2 dy-2)
                       (unstable-manifold T :pi 0. (* side dx) (* side dy) rho 1e-6))))
(define (draw T side color)
  (define curve (branch T side))
  (plot-parametric-fill win
                        (lambda (u)
                          (define p (curve u))
                          (up ((principal-value :pi) (abscissa p)) (ordinate p)))
                        0.1 660. (cylinder-near? 0.08) #:color color))
(for ([side '(1 -1)])
  (draw forwards side 'red)
  (draw backwards side 'blue))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-4-9.png"))

(module+ test
  (require rackunit)
  (define saddle (find-fixed-point forwards (up :pi 0.)))
  (test-case "the trace of what happens upside down"
    (check-= (apply + (fixed-point-multipliers saddle)) 4.63081658352 1e-8))
  (test-case "the map moves the manifold along itself by its multiplier"
    (define curve (branch forwards 1))
    (define p (curve 0.7))
    (define q (curve (* 0.7 (car (fixed-point-multipliers saddle)))))
    (define image (forwards (ref p 0) (ref p 1) up void))
    (check-= ((principal-value :pi) (- (ref image 0) (ref q 0))) 0 1e-5)
    (check-= (ref image 1) (ref q 1) 1e-5))
  (test-case "from one image to the next the excursions are longer, at last by a factor"
    (define curve (branch forwards 1))
    (define rho (car (fixed-point-multipliers saddle)))
    (define (distance v w)
      (sqrt (+ (square ((principal-value :pi) (- (ref v 0) (ref w 0))))
               (square (- (ref v 1) (ref w 1))))))
    (define (length-from u n)
      (define points (for/list ([k (+ n 1)]) (curve (* u (expt rho (/ k n 1.))))))
      (for/sum ([v points] [w (cdr points)]) (distance v w)))
    (define lengths (for/list ([u (list 8. (* 8 rho) (* 8 rho rho))]) (length-from u 400)))
    (check-true (apply < lengths))
    (check-true (> (/ (caddr lengths) (cadr lengths)) 1.5))))
