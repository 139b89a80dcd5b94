#lang mechanics
;; Exercise 9.9 (FDG 9): a universe that expands
;; Checked: Friedmann's two equations for the scale of a universe filled with a fluid
;; How: Einstein's equations of the metric, for an unknown scale, density and pressure

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

;; A fluid at rest, of density rho and pressure p, told by two 1-forms
(define inverse (metric:invert metric basis))
(define (fluid w1 w2)
  (+ (* (compose (+ (literal-function 'rho) (/ (literal-function 'p) (square 'c))) t)
        (w1 d/dt) (w2 d/dt))
     (* (compose (literal-function 'p) t) (inverse w1 w2))))

;; kappa = 8πG/c⁴
(define equations
  (- (Einstein-tensor metric basis) (* 'kappa ((drop2 metric basis) fluid))))
(define here ((point spacetime-sphere) (up 't 'r 'theta 'phi)))
((equations d/dt d/dt) here)

(define (now f) ((literal-function f) 't))
(define R. ((D (literal-function 'R)) 't))
(define R.. (((expt D 2) (literal-function 'R)) 't))
(define first
  (verify-equal ((equations d/dt d/dt) here)
                (- (/ (* 3 (+ (square R.) (* 'k (square 'c)))) (square (now 'R)))
                   (* 'kappa (expt 'c 4) (now 'rho)))))
(define (verify-second pressure)
  (verify-equal (* ((equations d/dr d/dr) here) (- 1 (* 'k (square 'r))))
                (- 0
                   (/ (+ (* 2 (now 'R) R..) (square R.) (* 'k (square 'c))) (square 'c))
                   (* 'kappa (square (now 'R)) pressure))))
(define second (verify-second (now 'p)))
first
second

;; The slip: pressure that drives the expansion, as gas drives a piston
(define wrong (verify-second (- (now 'p))))
(verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "Friedmann's equations"
    (check-pred proved? first)
    (check-pred proved? second)
    (check-pred refuted? wrong)))
