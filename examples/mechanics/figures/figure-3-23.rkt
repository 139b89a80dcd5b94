#lang mechanics
;; How chaotic orbits part that begin side by side  (SICM 3.7, Figure 3.23)
;;
;; Two stars of the energy 1/8, 1e-10 apart at first: the decimal logarithm of their distance at
;; each crossing, in units of that, until they are as far apart as can be.  In red what the
;; linearized map makes of it, which goes on growing.

(require mechanics/plot "star.rkt")

(define n 120)
(define (log10 x) (/ (log x) (log 10)))
(define chaotic (map (lambda (d) (log10 (/ (max d 1e-16) 1e-10))) (star-distances -0.15 n)))

;; The logarithm of how far a displacement (1, 0) has been stretched.
(define T (star-map 1/8))
(define (stretched n)
  (define (image p) (T (ref p 0) (ref p 1) up void))
  (for/fold ([all '()] [p (up -0.15 0.)] [v (up 1. 0.)] [sum 0.] #:result (reverse all)) ([k n])
    (define w (* ((D image) p) v))
    (define size (sqrt (+ (square (ref w 0)) (square (ref w 1)))))
    (define total (+ sum (log10 size)))
    (values (cons total all) (image p) (/ w size) total)))
(define linear (stretched n))

(define win
  (frame 0 n -1 (+ 1 (apply max linear))
         #:x-label "crossings" #:y-label "log (distance / first distance)"))
(for ([all (list chaotic linear)] [color '(black red)] [label '("two orbits" "linearized")])
  (for ([d all] [k n]) (plot-point win (+ k 1) d #:color color #:label label)))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-3-23.png"))

(module+ test
  (require rackunit)
  (define (mean all from to)
    (/ (for/sum ([d all] [k n] #:when (and (<= from k) (< k to))) d) (- to from)))
  (test-case "while small, the distance is that of the linearized motion"
    (for ([a chaotic] [b linear] [k 20]) (check-= a b 0.2)))
  (test-case "two orbits are soon as far apart as can be; the linearized ones go on parting"
    (check-true (< (mean chaotic 90 120) 10.1))
    (check-true (< (abs (- (mean chaotic 90 120) (mean chaotic 60 90))) 1))
    (check-true (> (mean linear 90 120) (+ 1 (mean linear 60 90)) 10))))
