#lang mechanics
;; Exercise 3.12 (SICM 3.8): an area of phase space, with a drive
;; Checked: a swarm about a start of the driven pendulum keeps its area, however it is deformed
;; How: the polygon of its edge is followed; and the determinant of the linearized flow

(require mechanics/book)

;; The pendulum of Figure 3.12.
(define-values (m l g A omega) (values 1. 1. 9.8 0.05 (* 4.2 (sqrt 9.8))))
(define period (/ :2pi omega))
(define (driven) (H-pend-sysder m l g A omega))
(define advance (state-advancer driven))
(define (moved t) (lambda (point) (advance (up 0 (ref point 0) (ref point 1)) t 1e-11)))
(define (in-plane s) (up (coordinate s) (momentum s)))

;; The edge of an ellipse about a point, 100 points: in the island, and where the chaos is.
(define (edge theta p)
  (for/list ([k 100])
    (define a (* :2pi (/ k 100.)))
    (up (+ theta (* 0.1 (cos a))) (+ p (* 0.3 (sin a))))))

;; The area within a polygon.
(define (area points)
  (for/sum ([p points] [q (append (cdr points) (list (car points)))])
    (* 1/2 (- (* (ref p 0) (ref q 1)) (* (ref q 0) (ref p 1))))))
(define (after t points) (map (lambda (p) (in-plane ((moved t) p))) points))
(define island (edge 0.8 0.))
(define zone (edge 3.1 0.5))
(define (areas points) (map (lambda (n) (area (after (* n period) points))) '(0 1 2)))
(areas island)
(areas zone)

;; An attempt: each small area keeps its size, though the Hamiltonian depends on the time.
(define (determinant-after t)
  (define J ((linearized-flow driven) (up 0. 3.1 0.5) t 1e-13))
  (- (* (ref J 1 1) (ref J 2 2)) (* (ref J 1 2) (ref J 2 1))))
(determinant-after (* 2 period))

;; A slip: that the shape is kept, too.  The edge gets longer, far more in the chaotic zone.
(define (length-of points)
  (for/sum ([p points] [q (append (cdr points) (list (car points)))])
    (sqrt (+ (square (- (ref p 0) (ref q 0))) (square (- (ref p 1) (ref q 1)))))))
(define (stretched points) (/ (length-of (after (* 2 period) points)) (length-of points)))
(define-values (in-island in-zone) (values (stretched island) (stretched zone)))
(list in-island in-zone)

(module+ test
  (require rackunit)
  (test-case "areas are kept"
    (for ([points (list island zone)])
      (for ([a (areas points)]) (check-= a (car (areas points)) 5e-3)))
    (check-= (determinant-after (* 2 period)) 1 1e-9))
  (test-case "shapes are not, least of all where motions are chaotic"
    (check-true (> in-zone (* 2 in-island)))))
