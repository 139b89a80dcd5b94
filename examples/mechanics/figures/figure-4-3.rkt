#lang mechanics
;; A section of the pendulum driven a little  (SICM 4.1, Figure 4.3)
;;
;; A = 0.001 m, ω = 4.2 ω₀: most orbits are as without a drive (Figure 4.2).  New are islands of
;; pendulums that go round once in each period of the drive, about (π, ±12.4); six islands of one
;; orbit that swings once in six periods; and a little chaos where the separatrix was.

(require mechanics/plot "strobe.rkt")

(define T (strobe-map 0.001 4.2))
(define win
  (strobe-section 0.001 4.2 20.
                  '((0.6 0.) (1.2 0.) (1.8 0.) (0. 5.58) (2.3 0.) (2.6 0.) (3.1 0.)
                    (0. 9.) (0. 11.) (2. 13.) (1.2 13.4) (0. 14.5) (0. 17.)
                    (0. -9.) (0. -11.) (2. -13.) (1.2 -13.4) (0. -14.5) (0. -17.))
                  250))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-4-3.png"))

(module+ test
  (require rackunit)
  (define turn (principal-value :pi))
  (define (fixed theta p n) (find-fixed-point T (up theta p) #:period n))
  (define (orbit theta p n)
    (for/fold ([all '()] [x theta] [y p] #:result (reverse all)) ([k n])
      (T x y (lambda (x2 y2) (values (cons (up x y) all) x2 y2)) void)))
  (test-case "with the drive, a stable orbit goes round and an unstable one: at π, and at 0"
    (for ([sign '(1 -1)])
      (define-values (stable unstable)
        (values (fixed 3.1 (* sign 12.4) 1) (fixed 0. (* sign 13.5) 1)))
      (check-equal? (fixed-point-kind stable) 'elliptic)
      (check-equal? (fixed-point-kind unstable) 'hyperbolic)
      (check-= (turn (- (ref (fixed-point-coordinates stable) 0) :pi)) 0 1e-9)
      (check-= (ref (fixed-point-coordinates unstable) 0) 0 1e-9)))
  (test-case "an orbit of the islands that go round stays beside π, where others pass by"
    (define (nearest-to-0 theta p)
      (apply min (map (lambda (v) (abs (turn (ref v 0)))) (orbit theta p 200))))
    (check-true (> (nearest-to-0 2. 13.) 1.5))
    (check-true (< (nearest-to-0 0. 11.) 0.1)))
  (test-case "six islands of one orbit, visited clockwise"
    (define points (orbit 0. 5.58 60))
    (define (direction v) (atan (/ (ref v 1) 5.6) (/ (ref v 0) 2.2)))
    (for ([v points] [w (cdr points)])
      (check-= (turn (- (direction w) (direction v))) (/ :2pi -6) 0.35))
    (for ([v points] [w (list-tail points 6)])
      (check-= (turn (- (direction w) (direction v))) 0 0.15))
    ;; and beside them an orbit that goes on turning through the sixths
    (define (drift theta p)
      (define six (map direction (for/list ([v (orbit theta p 300)] [k 300]
                                            #:when (= (modulo k 6) 0))
                                   v)))
      (- (apply max six) (apply min six)))
    (check-true (< (drift 0. 5.58) 0.15))
    (check-true (> (drift 1.8 0.) 1.)))
  (test-case "chaos where the separatrix was"
    (define (growth theta p) (car (Lyapunov-values (maximal-Lyapunov-exponent T (up theta p) 250))))
    (check-true (> (growth 3.1 0.) 0.1))
    (check-true (< (growth 1.2 0.) 0.03))))
