#lang mechanics
;; The region in which the pendulum swings  (SICM 7.2, Figure 7.4)
;;
;; Contours of the pendulum's energy.  The separatrix, red, has the energy of the pendulum at rest
;; at the top, and at θ = 0 the momentum 2 √(αβε).  Below √(αβε), the dotted lines, the first term
;; of the perturbative solution is larger than what it corrects: the scale is the same.

(require mechanics/plot mechanics/book)

(define-values (alpha beta) (values 1. 0.1))
(define (energy theta p) ((Hpendulum alpha beta) (up 0. theta p)))
(define p-sep (* 2 (sqrt (* alpha beta))))

(define picture (frame :-pi :pi -1.1 1.1 #:x-label "θ" #:y-label "p"))
(plot-contours picture energy '(-0.09 -0.05 0. 0.05 0.15 0.25 0.4))
(plot-contours picture energy beta #:samples 201 #:color 'red #:width 2)
(plot-point picture 0 p-sep #:color 'red #:size 6 #:label "p = 2 √(αβ)")
(for ([side '(-1 1)])
  (plot-line picture :-pi (* 1/2 side p-sep) :pi (* 1/2 side p-sep) #:style 'dot))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-4.png"))

(module+ test
  (require rackunit)
  (define H (+ (H0 'alpha) (* 'epsilon (H1 'beta))))
  (test-case "(7.24): the energy there is that at the top"
    (define p (* 2 (sqrt (* 'alpha 'beta 'epsilon))))
    (check-pred proved?
                (assuming ('(> alpha 0) '(> beta 0) '(> epsilon 0))
                  (verify-equal (H (up 't 0 p)) (H (up 't pi 0))))))
  (test-case "(7.22): the first correction of θ is sin θ times 1 at p = √(αβε)"
    (define p (sqrt (* 'alpha 'beta 'epsilon)))
    (define shift (* 'epsilon (((partial 2) (W 'alpha 'beta)) (up 't 'theta p))))
    (check-pred proved? (verify-equal shift (sin 'theta))))
  (test-case "below it the pendulum swings, above it turns and never rests"
    (define (momenta p)
      (define motion ((pendulum-advance alpha beta) (up 0. 0. p)))
      (for/list ([t 120]) (momentum (motion (* 0.5 t)))))
    (check-true (< (apply min (momenta (* 0.999 p-sep))) 0))
    (check-true (> (apply min (momenta (* 1.001 p-sep))) 0)))
  (test-case "its area is 2π times the action of the separatrix, 16 √(αβ)"
    (check-= (* :2pi (pendulum-separatrix-action alpha beta)) (* 16 (sqrt (* alpha beta))) 1e-12)
    (check-= (definite-integral
               (lambda (theta) (* 2 (sqrt (* 2 alpha beta (+ 1 (cos theta)))))) :-pi :pi 1e-8)
             (* 16 (sqrt (* alpha beta))) 1e-6)))
