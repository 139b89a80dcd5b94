#lang mechanics
;; How orbits part that begin side by side  (SICM 3.6.4, Figures 3.23 and 3.24)
;;
;; Two stars of the energy 1/8, 1e-10 apart at first: the logarithm of their distance at each
;; crossing. Regular motions part in proportion to the time, chaotic ones exponentially.

(require mechanics/plot "star.rkt")

(define T (star-map 1/8))

;; The distances after 1, 2, ... crossings.
(define (distances y n)
  (for/fold ([all '()] [a (up y 0.)] [b (up (+ y 1e-10) 0.)] #:result (reverse all)) ([k n])
    (define (moved p) (T (ref p 0) (ref p 1) up void))
    (define-values (a2 b2) (values (moved a) (moved b)))
    (define d (- a2 b2))
    (values (cons (sqrt (+ (square (ref d 0)) (square (ref d 1)))) all) a2 b2)))

(define n 200)
(define regular (distances 0.3 n))
(define chaotic (distances -0.15 n))

(define win
  (frame 0 n -11 1 #:x-label "crossings" #:y-label "decimal logarithm of the distance"))
(for ([all (list regular chaotic)] [color '(blue red)] [label '("regular" "chaotic")])
  (for ([d all] [k n])
    (plot-point win (+ k 1) (/ (log (max d 1e-16)) (log 10)) #:color color #:label label)))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-3-23.png"))

(module+ test
  (require rackunit)
  (test-case "linear, and exponential until as far apart as can be"
    (check-true (< (apply max regular) 1e-6))
    (check-true (> (apply max chaotic) 0.05))))
