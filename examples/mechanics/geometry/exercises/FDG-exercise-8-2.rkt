#lang mechanics
;; Exercise 8.2 (FDG 8): the pseudosphere
;; Checked: Christoffel's symbols of the surface, and that its curvature is the same everywhere
;; How: by the metric that space gives it, and by one that is known to have curvature -1

(require mechanics/geometry)
(define-coordinates (up t theta) R2-rect)
(define basis (coordinate-system->basis R2-rect))

;; A tractrix turned about its axis, in space
(define in-space (list (/ (cos theta) (cosh t)) (/ (sin theta) (cosh t)) (- t (tanh t))))
(define metric
  (make-metric (lambda (u v) (apply + (for/list ([x in-space]) (* ((d x) u) ((d x) v)))))))
(define here ((point R2-rect) (up 't 'theta)))
((metric->components metric basis) here)

(define symbols ((Christoffel->symbols (metric->Christoffel-2 metric basis)) here))
(define by-hand
  (let ([c (cosh 't)] [s (sinh 't)])
    (down (down (up (/ 1 (* c s)) 0) (up 0 (- (/ s c))))
          (down (up 0 (- (/ s c))) (up (/ 1 (* c s)) 0)))))
(define symbols-right (verify-equal symbols by-hand))
symbols-right

;; Twice Gauss's curvature, which is -1: a sphere has 2.
(define right (verify-equal (scalar-curvature metric basis) -2))
right
(define wrong (verify-equal (scalar-curvature metric basis) 2))
(verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "symbols and curvature"
    (check-pred proved? symbols-right)
    (check-pred proved? right)
    (check-pred refuted? wrong)))
