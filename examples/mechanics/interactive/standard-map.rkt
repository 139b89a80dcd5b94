#lang mechanics
;; The standard map: orbits of a rotor that is kicked once in each period. As the kicks grow, curves
;; break up into islands, and chaos spreads between them; at about 0.9716 the last curve that goes
;; all the way round is gone.

(require mechanics/plot mechanics/book)
(provide interaction)

(define interaction
  (interact ([K 0.0 2.5 #:start 0.6])
    (define f (frame 0 :2pi 0 :2pi #:x-label "θ" #:y-label "I" #:aspect-ratio 'equal))
    (explore-map f (standard-map K) 500 #:grid '(3 9))))
interaction

(module+ test
  (require rackunit)
  (define (heights K)
    (define f (frame 0 :2pi 0 :2pi))
    (map (lambda (p) (ref p 1)) (frame-points (explore-map f (standard-map K) 1000
                                                           #:starts (list (up 1. 2.))))))
  (define (span xs) (- (apply max xs) (apply min xs)))
  (test-case "an orbit keeps to its height without kicks, and to all of them with strong ones"
    (check-= (span (heights 0.)) 0 1e-9)
    (check-true (< (span (heights 0.5)) 3))
    (check-true (> (span (heights 2.5)) 6))))
