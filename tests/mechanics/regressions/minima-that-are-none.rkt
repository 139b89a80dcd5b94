#lang racket/base
;; The downhill simplex method gave −∞ as a minimum of a function that falls without end;
;; find-path took a saddle point at the straight line for a minimum, gave a path that was
;; off by a fifth through twenty points, and fell silent where its integrals did not settle.

(require mechanics
         (only-in mechanics/book L-harmonic)
         "../support/checks.rkt")

(test-case "a function that falls without end has no minimum"
  (for ([f (list (lambda (x) (- (square x))) (lambda (x) (- (exp x))) (lambda (x) (* 3 x)))])
    (check-exn exn:fail:mechanics:not-convergent? (lambda () (nelder-mead f 1)))
    (check-exn exn:fail:mechanics:not-convergent?
               (lambda () (multidimensional-minimize f 1 #:method 'nelder-mead)))))

(test-case "a saddle point of the action is no minimum"
  (check-exn exn:fail:mechanics:not-convergent?
             (lambda () (find-path (L-harmonic 1 1) 0 0 5 0 3))))

(test-case "a path through twenty points"
  (define q (find-path (L-harmonic 1 1) 0 1 :pi/2 0 20))
  (for ([t '(0.01 0.5 1.5)]) (check-= (q t) (cos t) 1e-9)))

(test-case "integrals that do not settle are a failure"
  (define (L s) (+ (square (velocity s)) (* (coordinate s) (if (< (time s) 1/3) 1 0))))
  (check-exn exn:fail:mechanics:not-convergent? (lambda () (find-path L 0 1 1 1 2))))
