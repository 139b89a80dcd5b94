#lang mechanics
;; Exercise 9.10 (FDG 9): the energy of a universe that expands
;; Checked: the fluid's energy changes by the work of its pressure, d(ρR³) = −p d(R³)/c²
;; How: the divergence of its tensor, for an unknown scale, density and pressure

(require mechanics/geometry)
(define-coordinates (up t r theta phi) spacetime-sphere)
(define basis (coordinate-system->basis spacetime-sphere))

;; Space of curvature k, whose lengths grow as R
(define metric
  (let ([R^2 (square (compose (literal-function 'R) t))])
    (make-metric
     (lambda (u v)
       (+ (* -1 (square 'c) (dt u) (dt v))
          (* R^2 (+ (/ (* (dr u) (dr v)) (- 1 (* 'k (square r))))
                    (* (square r) (dtheta u) (dtheta v))
                    (* (square (* r (sin theta))) (dphi u) (dphi v)))))))))

;; The fluid at rest of exercise 9.9, as a tensor of two 1-forms
(define inverse (metric:invert metric basis))
(define-values (R rho p)
  (values (literal-function 'R) (literal-function 'rho) (literal-function 'p)))
(define fluid
  (with-argument-types
   (lambda (w1 w2)
     (+ (* (compose (+ rho (/ p (square 'c))) t) (w1 d/dt) (w2 d/dt))
        (* (compose p t) (inverse w1 w2))))
   '(1form 1form)))

;; Its divergence in the direction of time
(define nabla (covariant-derivative (metric->Cartan metric basis)))
(define divergence
  ((contract (lambda (e w) (((nabla e) fluid) w dt)) basis)
   ((point spacetime-sphere) (up 't 'r 'theta 'phi))))
divergence

(define (verify-energy work)
  (verify-equal (* divergence (cube (R 't)))
                (+ ((D (* rho (cube R))) 't) (* work (p 't) ((D (cube R)) 't)))))
(define right (verify-energy (/ 1 (square 'c))))
right

;; The slip: matter counted and nothing else.  That is right for dust, which has no pressure.
(define wrong (verify-energy 0))
wrong

(module+ test
  (require rackunit)
  (test-case "energy and work"
    (check-pred proved? right)
    (check-pred refuted? wrong)))
