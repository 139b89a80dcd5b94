#lang racket/base
;; Functional Differential Geometry, chapter 3: vector fields, their flows, 1-forms.

(require mechanics
         mechanics/geometry
         "../../support/checks.rkt" "../../support/session.rkt")

(define-coordinates (up x y) R2-rect)
(define-coordinates (up r theta) R2-polar)

(define R2->R '(-> (UP Real Real) Real))
(define R2-rect-point ((point R2-rect) (up 'x0 'y0)))
(define f (literal-manifold-function 'f-rect R2-rect))
(define circular (- (* x d/dy) (* y d/dx)))

(define v
  (components->vector-field
   (up (literal-function 'b^0 R2->R) (literal-function 'b^1 R2->R)) R2-rect))

(define v-of-f
  '(+ (* (((partial 0) f-rect) (up x0 y0)) (b^0 (up x0 y0)))
      (* (((partial 1) f-rect) (up x0 y0)) (b^1 (up x0 y0)))))

(test-case "3.1: a vector field differentiates functions, and coordinates give its components"
  (check-prints ((v f) R2-rect-point) v-of-f)
  (check-prints ((v (chart R2-rect)) R2-rect-point) '(up (b^0 (up x0 y0)) (b^1 (up x0 y0))))
  (check-prints (((literal-vector-field 'b R2-rect) f) R2-rect-point) v-of-f))

(test-case "3.1: a vector field on coordinates, as an operator on their functions"
  (define (coordinatize v chart-of)
    (make-operator
     (lambda (f)
       (lambda (x)
         (* ((D f) x) ((compose (v (chart chart-of)) (point chart-of)) x))))
     'coordinatized))
  (check-prints (((coordinatize v R2-rect) (literal-function 'f-rect R2->R)) (up 'x0 'y0)) v-of-f))

(test-case "3.2: the vector fields of a chart"
  (check-prints ((d/dx (square r)) R2-rect-point) '(* 2 x0))
  (check-prints (((+ d/dx (* 2 d/dy)) (+ (square r) (* 3 x))) R2-rect-point)
                '(+ 3 (* 2 x0) (* 4 y0))))

(test-case "3.3: the flow of the circular field, by its series"
  (define terms
    (series:head (((exp (* 't circular)) (chart R2-rect)) ((point R2-rect) (up 1 0))) 6))
  (for ([term (in-list terms)]
        [expected '((up 1 0)
                    (up 0 t)
                    (up (* -1/2 (expt t 2)) 0)
                    (up 0 (* -1/6 (expt t 3)))
                    (up (* 1/24 (expt t 4)) 0)
                    (up 0 (* 1/120 (expt t 5))))])
    (check-prints term expected))
  (check-prints ((((evolution 6) 'delta-t circular) (chart R2-rect)) ((point R2-rect) (up 1 0)))
                '(up (+ 1 (* -1/720 (expt delta-t 6)) (* 1/24 (expt delta-t 4))
                        (* -1/2 (expt delta-t 2)))
                     (+ (* 1/120 (expt delta-t 5)) (* -1/6 (expt delta-t 3)) delta-t))))

;; ---------------------------------------------------------------------------

(define omega
  (components->1form-field
   (down (literal-function 'a_0 R2->R) (literal-function 'a_1 R2->R)) R2-rect))

(test-case "3.4: a 1-form on a basis gives its components"
  (check-prints ((omega (down d/dx d/dy)) R2-rect-point)
                '(down (a_0 (up x0 y0)) (a_1 (up x0 y0))))
  (check-prints (((literal-1form-field 'a R2-rect) (down d/dx d/dy)) R2-rect-point)
                '(down (a_0 (up x0 y0)) (a_1 (up x0 y0)))))

(test-case "3.4: the differential of a function"
  (check-prints (((d f) (coordinate-system->vector-basis R2-rect)) R2-rect-point)
                '(down (((partial 0) f-rect) (up x0 y0)) (((partial 1) f-rect) (up x0 y0))))
  (check-identity
   (((d (literal-manifold-function 'f-polar R2-polar)) (coordinate-system->vector-basis R2-rect))
    ((point R2-polar) (up 'r 'theta)))
   (let ([f_r (((partial 0) (literal-function 'f-polar R2->R)) (up 'r 'theta))]
         [f_theta (((partial 1) (literal-function 'f-polar R2->R)) (up 'r 'theta))])
     (down (- (* f_r (cos 'theta)) (/ (* f_theta (sin 'theta)) 'r))
           (+ (* f_r (sin 'theta)) (/ (* f_theta (cos 'theta)) 'r))))))

(test-case "3.4: the 1-forms of charts on the circular field"
  (define (at-point f) (f R2-rect-point))
  (check-prints (at-point (dx d/dy)) 0)
  (check-prints (at-point (dx d/dx)) 1)
  (check-prints (at-point (dx circular)) '(* -1 y0))
  (check-prints (at-point (dy circular)) 'x0)
  (check-prints (at-point (dr circular)) 0)
  (check-prints (at-point (dtheta circular)) 1)
  (check-prints (at-point ((- circular d/dtheta) f)) 0)
  (check-identity circular d/dtheta))

(test-case "3.4: not all 1-forms are differentials"
  (check-identity ((d (d f)) d/dx d/dy) 0)
  (check-pred refuted? (verify-equal (d omega) 0)))

(test-case "3.4: a 1-form of a vector field contracts the components"
  (define w (literal-1form-field 'a R2-rect))
  (define v (literal-vector-field 'b R2-rect))
  (check-prints ((w v) R2-rect-point)
                '(+ (* (a_0 (up x0 y0)) (b^0 (up x0 y0))) (* (a_1 (up x0 y0)) (b^1 (up x0 y0))))))
