#lang mechanics
;; Exercise 9.5 (FDG 9): Newton's equations from a curved spacetime
;; Checked: geodesics of the metric of a weak field fall with the acceleration −∇V
;; How: the residuals along an unknown path, for an unknown potential

(require mechanics/geometry)
(define-coordinates (up t x y z) spacetime-rect)
(define basis (coordinate-system->basis spacetime-rect))
(define V (literal-function 'V '(-> (UP Real Real Real) Real)))

;; Time goes by at another rate where the potential is another; space is flat.
(define metric
  (let ([a (+ 1 (* (/ 2 (square 'c)) (compose V (up x y z))))])
    (make-metric
     (lambda (u v)
       (+ (* -1 (square 'c) a (dt u) (dt v))
          (* (dx u) (dx v)) (* (dy u) (dy v)) (* (dz u) (dz v)))))))

;; A path by its place at each t
(define place (up (literal-function 'x) (literal-function 'y) (literal-function 'z)))
(define path
  (compose (point spacetime-rect)
           (lambda (t) (up t (ref (place t) 0) (ref (place t) 1) (ref (place t) 2)))
           (chart R1-rect)))
(define residual
  ((((geodesic-equation R1-rect spacetime-rect (metric->Cartan metric basis)) path)
    (chart spacetime-rect))
   ((point R1-rect) 't)))
(ref residual 1)

;; m a = −m ∇V in each direction
(define acceleration (((expt D 2) place) 't))
(define slope ((D V) (place 't)))
(define (verify-fall sign)
  (for/list ([i 3])
    (verify-equal (ref residual (+ i 1)) (+ (ref acceleration i) (* sign (ref slope i))))))
(define right (verify-fall 1))
right

;; The slip: the sign of the potential
(define wrong (verify-fall -1))
(map verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "Newton's equations"
    (for ([verdict right]) (check-pred proved? verdict))
    (for ([verdict wrong]) (check-pred refuted? verdict))))
