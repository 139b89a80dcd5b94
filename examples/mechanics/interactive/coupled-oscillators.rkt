#lang mechanics
;; Two masses between three springs. Started in one of its modes the system swings with one
;; frequency; started otherwise the motion wanders from one mass to the other, the slower the weaker
;; the spring between them.

(require mechanics/plot)
(provide interaction)

(define k 16.)
(define ((L-coupled c) (up t (up a b) (up va vb)))
  (- (* 1/2 (+ (square va) (square vb)))
     (* 1/2 k (+ (square a) (square b)))
     (* 1/2 c (square (- a b)))))

(define starts (hash "one mass" (up 1. 0.) "together" (up 1. 1.) "against each other" (up 1. -1.)))

(define (motion c start)
  (evolve-trajectory (Lagrangian->state-derivative (L-coupled c))
                     (up 0. (hash-ref starts start) (up 0. 0.)) 20.))

(define interaction
  (interact ([coupling 0.5 10.0 #:step 0.5 #:start 2.0]
             [start (list "one mass" "together" "against each other")])
    (define f (frame 0 20 -1.1 1.1 #:x-label "t" #:y-label "places" #:width 600 #:height 300))
    (define tr (motion coupling start))
    (plot-trajectory f tr (component 1 0) #:color 'blue)
    (plot-trajectory f tr (component 1 1) #:color 'red)
    f))
interaction

(module+ test
  (require rackunit)
  (test-case "a mode has one frequency, whatever the coupling or with it"
    (for ([c '(1. 5.)])
      (define (place start t) (ref ((motion c start) t) 1 0))
      (for ([t '(0.7 11.)])
        (check-= (place "together" t) (cos (* (sqrt k) t)) 1e-6)
        (check-= (place "against each other" t) (cos (* (sqrt (+ k (* 2 c))) t)) 1e-6)))))
