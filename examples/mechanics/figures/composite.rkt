#lang mechanics
;; A section put together of the perturbative solutions of three resonances, left, and the section
;; of the driven pendulum itself, right, for figures 7.10 and 7.11.  Each start on the left is told
;; by the theory of the resonance that is nearest; those of ω, 0 and −ω are blue, black and red.

(require mechanics/plot "resonances.rkt")

(provide resonances side-by-side)

(define resonances '((0 1) (-1 1) (1 1)))

(define (nearest p)
  (for/fold ([best '(0 1)]) ([k resonances])
    (if (< (abs (- p (middle k))) (abs (- p (middle best)))) k best)))

(define (side-by-side gamma starts n)
  (define picture
    (frame :-pi (* 3 pi) -8. 8. #:width 700 #:height 500
           #:x-label "θ of the theory, and 2π + θ of the pendulum" #:y-label "p"))
  (for ([start starts])
    (define k (nearest (cadr start)))
    (draw-theory picture gamma k (list start) n
                 #:color (cond [(= (middle k) 0) 'black]
                               [(> (middle k) 0) 'blue]
                               [else 'red])))
  (draw-section picture gamma starts n #:shift :2pi)
  (plot-line picture pi -8. pi 8.)
  picture)
