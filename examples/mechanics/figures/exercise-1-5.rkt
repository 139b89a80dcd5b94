#lang mechanics
;; Watching the minimization of an action  (SICM 1.4, p. 23, exercise 1.5)
;;
;; Each path that is tried on the way to the best one, lighter the earlier it was tried.
;; The search begins with the straight line.

(require mechanics/plot mechanics/book)

(define paths '())

(define best
  (find-path (L-harmonic 1.0 1.0) 0. 1. :pi/2 0. 3
             #:observe (lambda (path action) (set! paths (cons path paths)))))

(define picture
  (frame 0. :pi/2 0. 1.2 #:height 300 #:x-label "t" #:y-label "x"))

(define (grey i count)
  (let ([level (round (* 220 (- 1 (/ i count))))])
    (list level level level)))

(for ([path (reverse paths)] [i (in-naturals 1)])
  (plot-function picture path 0. :pi/2 (/ :pi/2 100)
                 #:color (grey i (length paths))))
(plot-function picture best 0. :pi/2 (/ :pi/2 100)
               #:color 'red #:label "least action")

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "exercise-1-5.png"))

(module+ test
  (require rackunit)
  (define (distance-from-cosine curve)
    (apply max (map (lambda (p) (abs (- (ref p 1) (cos (ref p 0))))) curve)))
  (define distances (map distance-from-cosine (frame-curves picture)))
  (test-case "the first path is the straight line, the last one nearly the cosine"
    (define straight (lambda (t) (- 1 (/ t :pi/2))))
    (for ([p (car (frame-curves picture))])
      (check-= (ref p 1) (straight (ref p 0)) 1e-9))
    (check-true (> (car distances) 0.1))
    (check-true (< (car (reverse distances)) 1.7e-4))))
