#lang mechanics
;; A heavy top seen from above: the way of the end of its axis. Spun fast it nods between two
;; circles as it goes round; let go against the sense in which it goes round it makes loops.

(require mechanics/plot mechanics/book)
(provide interaction)

(define-values (A C gMR) (values 6.96e-4 1.32e-4 0.112))
(define L (L-axisymmetric-top A C gMR))

(define (motion tilt turning spin)
  (evolve-trajectory (Lagrangian->state-derivative L)
                     (up 0. (up tilt 0. 0.) (up 0. turning spin)) 1.))

(define ((axis-end function) (up t (up theta phi psi) v)) (* (sin theta) (function phi)))

(define interaction
  (interact ([spin 140 300 #:start 200] [turning -20 20 #:start -10] [tilt 0.2 1.0 #:start 0.4])
    (define f (frame -1 1 -1 1 #:x-label "x" #:y-label "y" #:aspect-ratio 'equal))
    (plot-trajectory f (motion tilt turning spin) (axis-end cos) (axis-end sin))
    f))
interaction

(module+ test
  (require rackunit)
  (test-case "the tilt keeps to its range"
    (for ([spin '(150. 200. 300.)])
      (define tr (motion 0.4 -10. spin))
      (define range (nutation-range A C gMR (tr 0.)))
      (for ([t (in-range 0 1 1/50)])
        (check-true (<= (- (car range) 1e-6) (ref (tr t) 1 0) (+ (cadr range) 1e-6)))))))
