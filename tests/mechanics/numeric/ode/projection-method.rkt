#lang racket/base
;; Steps, and what is read between them, end on the manifold.

(require racket/flonum
         mechanics/numeric/ode/dormand-prince-54 mechanics/numeric/ode/dormand-prince-853
         mechanics/numeric/ode/integrate mechanics/numeric/ode/projection-method
         "../../support/checks.rkt")

;; Round the unit circle.
(define (rotation! y dy)
  (define-values (a b) (values (flvector-ref y 0) (flvector-ref y 1)))
  (flvector-set! dy 0 (fl- 0.0 b))
  (flvector-set! dy 1 a))

(define (off y) (abs (- (sqrt (+ (expt (flvector-ref y 0) 2) (expt (flvector-ref y 1) 2))) 1.0)))

(define (onto-circle! y)
  (define change (off y))
  (define r (+ 1.0 (- (sqrt (+ (expt (flvector-ref y 0) 2) (expt (flvector-ref y 1) 2))) 1.0)))
  (for ([k 2]) (flvector-set! y k (fl/ (flvector-ref y k) r)))
  change)

;; -> the greatest distance from the circle, at ends of steps and between, and the error
(define (run m)
  (define out (make-flvector 2))
  (define greatest 0.0)
  (define (visit from to interpolant)
    (define at (interpolant))
    (for ([theta '(0.0 0.3 0.7 1.0)])
      (at theta out)
      (set! greatest (max greatest (off out))))
    #t)
  (define-values (t last)
    (integrate m rotation! (flvector 1.0 0.0) 0.0 100.0 #:tolerance 1e-6 #:visit visit))
  (values greatest
          (max (abs (- (flvector-ref last 0) (cos 100.0)))
               (abs (- (flvector-ref last 1) (sin 100.0))))))

(for ([m (list dormand-prince-54 dormand-prince-853)])
  (test-case (format "~a" m)
    (define-values (free-off free-error) (run m))
    (define-values (kept-off kept-error) (run (projected-method m onto-circle!)))
    (check-true (> free-off 1e-8))
    (check-true (< kept-off 1e-15))
    (check-true (< kept-error (* 2 free-error)))))
