#lang mechanics
;; A section of the driven rotor with the islands 1:3  (SICM 4.5.1, Figure 4.19)
;;
;; Three islands of one orbit, about the stable points where the curves of Figure 4.18 cross, among
;; orbits that go round a little faster or more slowly.

(require mechanics/plot "radial.rkt")

(define win (frame :-pi :pi 3 6 #:x-label "θ" #:y-label "p_θ"))
(define section
  (explore-map win rotor-map 500
               #:starts (append (for/list ([p '(3.94 3.97 4. 4.03)]) (up :pi p))
                              (for/list ([p '(3.6 3.9 4.2 4.5 4.65 4.8 5.2 5.5 5.8)]) (up 0. p)))))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-4-19.png"))

(module+ test
  (require rackunit)
  (define stable (find-fixed-point rotor-map (up 3.14 3.95) #:period 3))
  (define-values (theta p)
    (values (ref (fixed-point-coordinates stable) 0) (ref (fixed-point-coordinates stable) 1)))
  (define (turns p) (rotation-value (rotation-number rotor-map (up :pi p) 3000)))
  (test-case "a stable point at π"
    (check-equal? (fixed-point-kind stable) 'elliptic)
    (check-= (turn (- theta :pi)) 0 1e-8))
  (test-case "an orbit of the islands comes near each of the three points in turn"
    (define third (iterated-map rotor-map 3))
    (for/fold ([x theta] [y (+ p 0.02)] #:result (void)) ([k 100])
      (check-true (< (abs (turn (- x theta))) 0.4))
      (third x y values void)))
  (test-case "there it goes round once in three periods; below it more slowly, above it faster"
    (for ([d '(0. 0.02)]) (check-= (turns (+ p d)) 1/3 1e-6))
    (check-true (< (turns (- p 0.4)) (- 1/3 1e-3)))
    (check-true (> (turns (+ p 0.6)) (+ 1/3 1e-3)))))
