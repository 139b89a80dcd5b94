#lang racket/base
;; Connections, curvature and brackets against differences of plain functions of numbers.

(require (only-in racket/base [sin fl-sin] [cos fl-cos])
         (except-in mechanics sin cos) (only-in mechanics [sin g-sin] [cos g-cos])
         mechanics/geometry
         "../support/checks.rkt" "../support/numeric-geometry.rkt" "../support/random.rkt"
         "../support/same.rkt")

;; A metric twice: numbers to lists of numbers, and the library's
(struct sample (name chart low high numeric field))

(define-coordinates (up x y) R2-rect)
(define-coordinates (up theta phi) S2-spherical)

(define skew
  (sample "a metric with products" R2-rect 0.2 1.0
          (lambda (x y) (list (list (+ 2.0 (* x y)) (* 0.5 (fl-sin x)))
                              (list (* 0.5 (fl-sin x)) (+ 1.0 (* y y x)))))
          (make-metric
           (lambda (u v)
             (+ (* (+ 2 (* x y)) (dx u) (dx v))
                (* 1/2 (g-sin x) (+ (* (dx u) (dy v)) (* (dy u) (dx v))))
                (* (+ 1 (* y y x)) (dy u) (dy v)))))))

(define sphere
  (sample "the sphere" S2-spherical 0.5 1.2
          (lambda (theta phi) (list (list 1.0 0.0) (list 0.0 (expt (fl-sin theta) 2))))
          S2-metric))

(define stereographic
  (sample "the sphere, projected" S2-stereographic 0.5 1.2
          (lambda (x y)
            (define a (/ 4.0 (expt (+ 1.0 (* x x) (* y y)) 2)))
            (list (list a 0.0) (list 0.0 a)))
          S2-metric))

(define spherical
  (sample "space, spherical" R3-spherical 0.5 1.2
          (lambda (r theta phi)
            (list (list 1.0 0.0 0.0) (list 0.0 (* r r) 0.0)
                  (list 0.0 0.0 (expt (* r (fl-sin theta)) 2))))
          (coordinate-system->metric R3-rect)))

(define Schwarzschild
  (let ()
    (define-coordinates (up t r theta phi) spacetime-sphere)
    (define a (- 1 (/ 1/4 r)))
    (sample "Schwarzschild's spacetime" spacetime-sphere 0.6 1.2
            (lambda (t r theta phi)
              (define a (- 1.0 (/ 0.25 r)))
              (list (list (- a) 0.0 0.0 0.0) (list 0.0 (/ 1.0 a) 0.0 0.0)
                    (list 0.0 0.0 (* r r) 0.0)
                    (list 0.0 0.0 0.0 (expt (* r (fl-sin theta)) 2))))
            (make-metric
             (lambda (u v)
               (+ (* -1 a (dt u) (dt v)) (* (/ 1 a) (dr u) (dr v))
                  (* (square r) (+ (* (dtheta u) (dtheta v))
                                   (* (square (g-sin theta)) (dphi u) (dphi v))))))))))

;; ---------------------------------------------------------------------------

(define (random-place s)
  (for/list ([_ (coordinate-system-dimension (sample-chart s))])
    (+ (sample-low s) (* (random) (- (sample-high s) (sample-low s))))))

(for ([s (list skew sphere stereographic spherical Schwarzschild)])
  (define C (sample-chart s))
  (define n (coordinate-system-dimension C))
  (define basis (coordinate-system->basis C))
  (define-values (es ws) (values (basis->vector-basis basis) (basis->1form-basis basis)))
  (define (e i) (ref es i))
  (define (w i) (ref ws i))
  (define Cartan (metric->Cartan (sample-field s) basis))
  (define nabla (covariant-derivative Cartan))
  (define R (Riemann nabla))
  (define symbols (Christoffel->symbols (Cartan->Christoffel Cartan)))
  (with-seed 7
    (for ([_ 2])
      (define x (random-place s))
      (define m ((point C) (apply up x)))
      (define (at f) (if (number? f) f (f m)))
      (test-case (format "Christoffel's symbols of ~a" (sample-name s))
        (define expected (numeric-Christoffel (sample-numeric s) x))
        (for* ([k n] [j n] [i n])
          (check-same (at (ref symbols k j i)) (expected i j k) 1e-9)))
      (test-case (format "the curvature of ~a" (sample-name s))
        (define expected (numeric-Riemann (sample-numeric s) x))
        ;; in four dimensions, some of the 256
        (for* ([a n] [b n] [k n] [l k] #:when (or (< n 4) (= (modulo (+ a (* 2 b) k l) 5) 0)))
          (check-same (at (R (w a) (e b) (e k) (e l))) (expected a b k l) 1e-7)))
      (test-case (format "Ricci's tensor of ~a" (sample-name s))
        (define expected (numeric-Ricci (sample-numeric s) x))
        (for* ([b n] [l n] #:when (or (< n 4) (= b l)))
          (check-same (at ((Ricci nabla basis) (e b) (e l))) (expected b l) 1e-7))))))

(test-case "brackets of vector fields"
  (define (X x y) (list (* x y) (fl-sin x)))
  (define (Y x y) (list (fl-cos y) (* x x y)))
  (define as-fields
    (commutator (+ (* x y d/dx) (* (g-sin x) d/dy)) (+ (* (g-cos y) d/dx) (* x x y d/dy))))
  (with-seeds 5
    (define place (list (random-flonum) (random-flonum)))
    (define m ((point R2-rect) (apply up place)))
    (check-same (up ((as-fields x) m) ((as-fields y) m))
                (apply up (numeric-bracket X Y place)) 1e-9)))
