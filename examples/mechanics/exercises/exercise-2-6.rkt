#lang mechanics
;; Exercise 2.6 (SICM 2.5): principal moments of inertia
;; Checked: moments and axes of a tetrahedron, a cube, and five points
;; How: by principal-moments and principal-axes, exact where they can be

;; Find the principal moments about the centre of mass, and the axes, of four equal masses at the
;; corners of a regular tetrahedron, of a homogeneous cube, and of five equal masses at
;; (−1, 0, 0), (1, 0, 0), (1, 1, 0), (0, 0, 0) and (0, 0, 1).

(define (center points) (/ (apply + points) (length points)))
(define (about-center m points)
  (define c (center points))
  (inertia-tensor (for/list ([_ points]) m) (for/list ([p points]) (- p c))))

;; Every second corner of a cube with the edge 2 a.
(define corners
  (for/list ([p (list (up 1 1 1) (up 1 -1 -1) (up -1 1 -1) (up -1 -1 1))]) (* 'a p)))
(define tetrahedron (about-center 'm corners))
(principal-moments tetrahedron)

;; All are equal: any axis is a principal one.  So it is with the cube.
(define cube-moments (principal-moments (box-inertia 'M 'l 'l 'l)))
cube-moments

;; An attempt: m s², with the edge s of the tetrahedron.
(define (compared s^2) (verify-equal (ref (principal-moments tetrahedron) 0) (* 'm s^2)))
(define right (compared (square (- (car corners) (cadr corners)))))
right

;; A slip: the edge of the cube for that of the tetrahedron.
(define wrong (compared (square (* 2 'a))))
wrong

;; Five points.
(define points (list (up -1 0 0) (up 1 0 0) (up 1 1 0) (up 0 0 0) (up 0 0 1)))
(define five (about-center 1 points))
five
(principal-moments five)

;; The axes are a rotation that makes the tensor diagonal.
(define M (principal-axes five))
(define turned (* (transpose M) (* five M)))
(define (off-diagonal m)
  (for*/fold ([most 0]) ([i 3] [j 3] #:unless (= i j)) (max most (abs (matrix-ref m i j)))))
(< (off-diagonal turned) 1e-14)

;; A slip: about the origin, where one of the points is, instead of the centre of mass.
(define slip (inertia-tensor '(1 1 1 1 1) points))
(principal-moments slip)

(module+ test
  (require rackunit)
  (test-case "a tetrahedron and a cube have equal moments"
    (check-equal? (expression (principal-moments tetrahedron))
                  '(up (* 8 (expt a 2) m) (* 8 (expt a 2) m) (* 8 (expt a 2) m)))
    (check-equal? (expression (ref cube-moments 0)) '(* 1/6 M (expt l 2))))
  (test-case "the edge of the tetrahedron"
    (check-pred proved? right)
    (check-pred refuted? wrong))
  (test-case "five points: a rotation to the axes, and the trace"
    (check-true (< (off-diagonal turned) 1e-14))
    (check-= (apply + (structure->list (principal-moments five))) (trace five) 1e-12)
    (check-= (determinant M) 1 1e-12))
  (test-case "about another point the moments are greater"
    (for ([greater (principal-moments slip)] [less (principal-moments five)])
      (check-true (>= greater less)))))
