#lang mechanics
;; Exercise 3.1 (FDG 3): motions as the flow of a vector field
;; Checked: a state derivative as a vector field on states, and what its exponential makes of x
;; How: term by term, and against the motion of a ball that is thrown

(require mechanics/geometry)

;; States have five coordinates: the time, two of the place, two of the velocity.
(define states (coordinate-system-at 'rectangular 'origin (make-manifold R^n 5)))
(define-coordinates (up t x y vx vy) states)
(define start ((point states) (up 't0 'x0 'y0 'u 'w)))

;; The field that an acceleration (ax, ay) makes
(define (state-field ax ay)
  (+ d/dt (* vx d/dx) (* vy d/dy) (* ax d/dvx) (* ay d/dvy)))
(define (after f field) (((exp (* 's field)) f) start))

;; An acceleration that depends on the place
(define (literal name) (compose (literal-function name '(-> (UP Real Real) Real)) (up x y)))
(define terms (list->up (series:head (after x (state-field (literal 'ax) (literal 'ay))) 3)))
terms

;; A ball: the series ends.
(define height (series:sum (after y (state-field 0 (- 'g))) 5))
(define right (verify-equal height (+ 'y0 (* 's 'w) (* -1/2 'g (square 's)))))
right

;; The slip: d/dt left out, where the acceleration depends on the time
(define pushed (state-field 0 (* 'k t)))
(define (third-term field) (series:ref (after y field) 3))
(define wrong (verify-equal (third-term (- pushed d/dt)) (third-term pushed)))
wrong

(module+ test
  (require rackunit)
  (test-case "the first terms"
    (define ax ((literal-function 'ax '(-> (UP Real Real) Real)) (up 'x0 'y0)))
    (check-pred proved? (verify-equal terms (up 'x0 (* 's 'u) (* 1/2 (square 's) ax)))))
  (test-case "a ball"
    (check-pred proved? right)
    (check-pred refuted? wrong)))
