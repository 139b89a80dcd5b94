#lang mechanics
;; Exercise 9.3 (FDG 9): the curvature of a sphere
;; Checked: a sphere of radius r has the scalar curvature 2/r²
;; How: Ricci's tensor and its trace

(require mechanics/geometry)
;; Two dimensions, in a space of three
(define spherical
  (coordinate-system-at 'spherical 'north-pole (make-manifold S^2-type 2 3)))
(define-coordinates (up theta phi) spherical)
(define basis (coordinate-system->basis spherical))
(define (sphere r)
  (make-metric
   (lambda (u v)
     (* (square r)
        (+ (* (dtheta u) (dtheta v)) (* (square (sin theta)) (dphi u) (dphi v)))))))

(define g (sphere 'r))
(define R (Ricci (covariant-derivative (metric->Cartan g basis)) basis))
(define right (verify-equal ((trace2down g basis) R) (/ 2 (square 'r))))
right

;; The library's own
(define same (verify-equal (scalar-curvature g basis) (/ 2 (square 'r))))
same

;; The slip: the trace by the metric of the unit sphere, which is 2 for all spheres
(define wrong (verify-equal ((trace2down (sphere 1) basis) R) (/ 2 (square 'r))))
wrong

(module+ test
  (require rackunit)
  (test-case "small spheres are curved most"
    (check-pred proved? right)
    (check-pred proved? same)
    (check-pred refuted? wrong)))
