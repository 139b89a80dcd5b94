#lang mechanics
;; A universe that is everywhere the same and expands: Friedmann's equations from the metric.

(require mechanics/geometry)
(define-coordinates (up t r theta phi) spacetime-sphere)
(define basis (coordinate-system->basis spacetime-sphere))
(define event ((point spacetime-sphere) (up 't 'r 'theta 'phi)))

;; Space has the curvature k, and its lengths grow as a(t); c = 1.
(define a (compose (literal-function 'a) t))
(define metric
  (make-metric
   (lambda (u v)
     (+ (* -1 (dt u) (dt v))
        (* (square a)
           (+ (/ (* (dr u) (dr v)) (- 1 (* 'k (square r))))
              (* (square r) (dtheta u) (dtheta v))
              (* (square r) (square (sin theta)) (dphi u) (dphi v))))))))

;; A fluid at rest in these coordinates, with density and pressure.
(define rho (compose (literal-function 'rho) t))
(define p (compose (literal-function 'p) t))
(define fluid
  (make-metric (lambda (u v) (+ (* (+ rho p) (dt u) (dt v)) (* p (metric u v))))))

;; Einstein's equations
(define equations (- (Einstein-tensor metric basis) (* 8 ':pi 'G fluid)))

;; Friedmann's first: the rate of expansion
((equations d/dt d/dt) event)

;; and the second, the same in all three directions of space
(define second (/ ((equations d/dr d/dr) event) ((metric d/dr d/dr) event)))
second

;; Off the diagonal there is none.
((equations d/dt d/dr) event)

;; They agree with each other if energy is kept, which Bianchi's identity asks for.
(define (rate f) (d/dt f))
(define energy (+ (rate rho) (* 3 (/ (rate a) a) (+ rho p))))
(define first (equations d/dt d/dt))
(define kept
  (verify-equal (+ (rate first) (* 3 (/ (rate a) a)
                                   (+ first (/ (equations d/dr d/dr) (metric d/dr d/dr)))))
                (* -8 ':pi 'G energy)))
kept

;; Einstein and de Sitter: flat space and dust, a = t^(2/3).
(define (with-scale f)
  (define a (f t))
  (make-metric
   (lambda (u v)
     (+ (* -1 (dt u) (dt v))
        (* (square a)
           (+ (* (dr u) (dr v))
              (* (square r) (dtheta u) (dtheta v))
              (* (square r) (square (sin theta)) (dphi u) (dphi v))))))))
(define dust
  (verify-equal (Einstein-tensor (with-scale (lambda (t) (expt t 2/3))) basis)
                (make-metric (lambda (u v) (* (/ 4 (* 3 (square t))) (dt u) (dt v))))))
dust

(module+ test
  (require rackunit)
  (define scale (literal-function 'a))
  (define-values (a a. a..) (values (scale 't) ((D scale) 't) (((expt D 2) scale) 't)))
  (define-values (rho p) (values ((literal-function 'rho) 't) ((literal-function 'p) 't)))
  (test-case "Friedmann's equations"
    (check-pred proved?
                (verify-equal ((equations d/dt d/dt) event)
                              (- (/ (* 3 (+ (square a.) 'k)) (square a)) (* 8 ':pi 'G rho))))
    (check-pred proved?
                (verify-equal second
                              (- 0 (/ (* 2 a..) a) (/ (+ (square a.) 'k) (square a))
                                 (* 8 ':pi 'G p)))))
  (test-case "the same in all directions, and none between them"
    (for ([v (list d/dtheta d/dphi)])
      (check-pred proved? (verify-equal (/ ((equations v v) event) ((metric v v) event)) second)))
    (check-pred proved? (verify-equal (equations d/dt d/dr) 0)))
  (test-case "they agree, and dust solves them"
    (check-pred proved? kept)
    (check-pred proved? dust)))
