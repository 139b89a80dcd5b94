#lang mechanics
;; Spin and orbit on a circle: the phase plane  (SICM 2.11.3, Figure 2.14)
;;
;; With φ = θ − nt the energy ½ φ̇² − ¼ n² ε² cos 2φ is kept, and motions are its contours: two
;; islands, one for each face of the Moon, between motions that go round.  In red the
;; separatrix, which is as high as n ε.

(require mechanics/plot)

(define-values (n epsilon) (values 1. 0.026))
(define (E phi phidot)
  (- (* 1/2 (square phidot)) (* 1/4 (square (* n epsilon)) (cos (* 2 phi)))))

(define picture
  (frame :-pi :pi -0.05 0.05 #:width 500 #:height 350 #:x-label "φ" #:y-label "Dφ"))
(plot-contours picture E (for/list ([phi '(0.4 0.8 1.2)]) (E phi 0.)) #:samples 101)
(plot-contours picture E (for/list ([rate '(0.03 0.035 0.042)]) (E 0. rate)) #:samples 101)
(define edge (E (/ pi 2) 0.))
(plot-contours picture E edge #:samples 201 #:color 'red)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-2-14.png"))

(module+ test
  (require rackunit)
  (test-case "the separatrix is as high as n ε"
    (check-= (E 0. (* n epsilon)) edge 1e-18))
  (test-case "the energy is that of the motion on a circle"
    (define L (L-spin-orbit 1 'n 'epsilon (lambda (t) 1) (lambda (t) (* 'n t))))
    (define (kept s)
      (- (* 1/2 (square (- (velocity s) 'n)))
         (* 1/4 (square (* 'n 'epsilon)) (cos (* 2 (- (coordinate s) (* 'n (time s))))))))
    (check-pred proved? (verify-conserved L kept (up 't 'theta 'thetadot))))
  (test-case "both faces are places of least energy, the edges between them saddles"
    (for ([phi (list 0. pi)])
      (for ([d '(0.1 -0.1)]) (check-true (< (E phi 0.) (E (+ phi d) 0.)))))
    (check-true (> edge (E (+ (/ pi 2) 0.1) 0.)))))
