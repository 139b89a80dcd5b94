#lang mechanics
;; Secular terms  (SICM 7.2.1, Figure 7.6)
;;
;; The solution of figure 7.5 for ten times as long.  The pendulum, blue, goes round one closed
;; curve.  The second generator has the angle itself in it, which grows; so does the error.

(require mechanics/plot "rotor.rkt" "refined.rkt")

(define (free p epsilon) (/ (square p) (* 2 alpha)))
(define told ((two-steps W-secular free) (start 0.7)))
(define true (truth (start 0.7)))

(define picture (plane 0. 0.9))
(draw-points picture told 100. 0.05)
(draw-points picture true 100. 0.05 #:color 'blue)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-6.png"))

(module+ test
  (require rackunit)
  ;; The greatest error of the momentum in a time
  (define (worst from to)
    (for/fold ([most 0.]) ([t (in-range from to 0.25)])
      (max most (abs (- (momentum (told t)) (momentum (true t)))))))
  (test-case "the error grows"
    (define errors (for/list ([k '(0 3 6 9)]) (worst (* 10. k) (* 10. (+ k 1)))))
    (check-true (apply < errors))
    (check-true (> (list-ref errors 3) (* 10 (car errors)))))
  (test-case "and after seven turns the pendulum is where it was, the solution is not"
    (define T (turn-time true))
    (check-= (momentum (true (* 7 T))) 0.7 1e-7)
    (check-true (> (abs (- (momentum (told (* 7 T))) 0.7)) 0.15))))
