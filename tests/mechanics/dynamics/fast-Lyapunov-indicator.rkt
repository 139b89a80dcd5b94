#lang racket/base
;; Regular or chaotic, told by a displacement.

(require mechanics
         mechanics/book
         (only-in mechanics/dynamics/map-indicator indicator-grid)
         racket/flonum
         "../support/checks.rkt" "../support/close.rkt" "../support/messages.rkt")

(define (nan? x) (not (= x x)))

(test-case "of a shear it is the logarithm of how far it shears"
  (define (shear x y return fail) (return (+ x y) y))
  (check-close (fast-Lyapunov-indicator shear (up 0 1) 1000)
               (log (sqrt (+ (square (+ 0.6 800.0)) 0.64)) 10)
               1e-12))

(test-case "of a saddle it grows by the logarithm of the multiplier at each step, without end"
  (define (saddle x y return fail) (return (* 2 x) (/ y 2)))
  (check-close (fast-Lyapunov-indicator saddle (up 0 0) 10000)
               (+ (log 0.6 10) (* 10000 (log 2 10)))
               1e-9))

(test-case "an island and the sea around it"
  (define T (standard-map 1.0))
  (check-true (< (fast-Lyapunov-indicator T (up :pi 1)) 4))
  (check-true (> (fast-Lyapunov-indicator T (up 0.1 0.1)) 50)))

(test-case "the same with a map that is not compiled; where an orbit ends there is none"
  (define T (standard-map 1.0))
  (define (called x y return fail) (if (> x -1) (T x y return fail) (fail)))
  (define at (up 0.5 1.5))
  (check-close (fast-Lyapunov-indicator called at 50) (fast-Lyapunov-indicator T at 50) 1e-9)
  (define (ends x y return fail) (if (> x 3) (fail) (return (+ x 1) y)))
  (check-true (nan? (fast-Lyapunov-indicator ends (up 0 0) 10))))

(test-case "many cores give what one gives"
  (define T (standard-map 1.2))
  (define xs (flvector 0.5 1.0 1.5 2.0))
  (define ys (flvector 0.3 0.9 1.7))
  (define all (indicator-grid 'chaos-map T xs ys 200))
  (check-equal? (flvector-length all) 12)
  (for* ([j 3] [i 4])
    (check-equal? (flvector-ref all (+ i (* 4 j)))
                  (fast-Lyapunov-indicator T (up (flvector-ref xs i) (flvector-ref ys j)) 200))))

(says
 [(fast-Lyapunov-indicator (standard-map 1) (up 0 0) 0)
  "fast-Lyapunov-indicator: expected "
  "how many steps of the map, a positive integer\n  given: the number 0"]
 [(fast-Lyapunov-indicator sin (up 0 0))
  "fast-Lyapunov-indicator: expected a map, a procedure of two coordinates and of two procedures\n"
  "  given: the procedure `sin`, which takes 1 argument"])
