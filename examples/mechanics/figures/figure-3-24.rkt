#lang mechanics
;; How regular orbits part that begin side by side  (SICM 3.7, Figure 3.24)
;;
;; Two stars of the energy 1/8, 1e-10 apart at first: their distance at each crossing, in units of
;; that, grows in proportion to the time.

(require mechanics/plot "star.rkt")

(define n 150)
(define regular (map (lambda (d) (/ d 1e-10)) (star-distances 0.2 n)))

(define win
  (frame 0 n 0 (* 1.1 (apply max regular))
         #:x-label "crossings" #:y-label "distance / first distance"))
(for ([d regular] [k n]) (plot-point win (+ k 1) d))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-3-24.png"))

(module+ test
  (require rackunit)
  (test-case "no faster than the time: as much in the second half as in the first"
    (define (greatest from to) (apply max (for/list ([d regular] [k n] #:when (<= from k to)) d)))
    (define half (quotient n 2))
    (check-true (< (/ (greatest 0 n) (greatest 0 half)) 4))
    (check-true (< (greatest 0 n) (* 20 n)))))
