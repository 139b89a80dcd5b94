#lang mechanics
;; A section of the driven rotor with the islands 1:1  (SICM 4.5.1, Figure 4.17)
;;
;; Fixed points are where the curves of Figure 4.16 cross: islands around those at π, and the
;; corners of the islands' edges at those at 0.

(require mechanics/plot "radial.rkt")

(define win (frame :-pi :pi -20 20 #:x-label "θ" #:y-label "p_θ"))
(define starts
  (append (for*/list ([sign '(1 -1)] [p '(13.9 15.2 16.8 18. 19.2)]) (list 3.1 (* sign p)))
          (for*/list ([sign '(1 -1)] [p '(0.6 1.6 2.6 3.6 4.6 6. 8.)]) (list 0. (* sign p)))
          '((0.05 12.8) (0.05 -12.8))))
(define section
  (explore-map win rotor-map 250
               #:starts (map (lambda (start) (apply up start)) starts)))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-4-17.png"))

(module+ test
  (require rackunit)
  (define (fixed theta p) (find-fixed-point rotor-map (up theta p)))
  (define stable (fixed 3.14 13.5))
  (define unstable (fixed 0.01 12.8))
  (define (angles theta p n)
    (for/fold ([all '()] [theta theta] [p p] #:result all) ([k n])
      (rotor-map theta p (lambda (theta p) (values (cons theta all) theta p)) void)))
  (test-case "an island around the stable point; its edge passes the unstable one"
    (check-equal? (fixed-point-kind stable) 'elliptic)
    (check-equal? (fixed-point-kind unstable) 'hyperbolic)
    (define (least theta p) (apply min (map abs (angles theta p 250))))
    (check-true (> (least 3.1 15.2) 1.5))
    (check-true (< 0.1 (least 3.1 18.) 1.5))
    (check-true (< (least 0.05 12.8) 0.1)))
  (test-case "near the stable point orbits turn about it by the angle of its multiplier"
    (define about (fixed-point-coordinates stable))
    (define r (rotation-number rotor-map (+ about (up 0. 0.01)) 500 #:about about))
    (check-= (* :2pi (abs (rotation-value r))) (fixed-point-rotation-angle stable) 1e-4))
  (test-case "in the island the rotor goes round with the drive; below it, more slowly"
    ;; whole turns do not count
    (define (turns theta p) (rotation-value (rotation-number rotor-map (up theta p) 2000)))
    (check-= (sin (* pi (turns 3.1 15.2))) 0 1e-6)
    (check-true (< 0.2 (turns 0. 4.6) (turns 0. 6.) (turns 0. 8.) 0.9))))
