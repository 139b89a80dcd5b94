#lang racket/base
;; Methods whose steps end on a manifold (Hairer, Lubich and Wanner, Geometric Numerical
;; Integration, IV.4).
;;
;; A solution of y' = f(y) that begins on a manifold which f is tangent to stays there; an
;; approximation drifts off, by its error.  Projected back after each step, it stays, and its
;; error is of the same order.  States read between the steps are projected as well; at their
;; ends that changes nothing, so the motion has no jumps.

(require racket/flonum
         "stepper.rkt")

(provide projected-method)

;; project! : y -> the greatest change of a component, relative to 1 + |y|
(define (projected-method m project!)
  (define (start f! y0 . tolerance)
    (projected (apply (method-start m) f! y0 tolerance) f! project!))
  (struct-copy method m [start start]))

(define (projected s f! project!)
  (define y (stepper-state s))
  ;; The slope at the end of a step may be that where the next one begins.
  (define (accept!)
    ((stepper-accept! s))
    (when (fl> (project! y) rounding) (f! y ((stepper-slope s)))))
  ;; There is one room to project in: one thread at a time.
  (define lock (make-semaphore 1))
  (define (interpolant)
    (define at ((stepper-interpolant s)))
    (lambda (theta out)
      (at theta out)
      (call-with-semaphore lock project! #f out)
      (void)))
  (struct-copy stepper s [accept! accept!] [interpolant interpolant]))

(define rounding 1e-15)
