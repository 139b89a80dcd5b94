#lang racket/base
;; Hénon's map, called H as in his paper, was refused as a Hamiltonian; the state derivative of any
;; number of arguments, as a map; and a map of states was done once more than was needed.

(require mechanics "../support/checks.rkt")

;; x = 1 + y - a x², y = b x: fixed where a x² + (1 - b) x = 1
(define-values (a b) (values 1.4 0.3))
(define (H x y return fail) (return (+ 1 y (* -1 a x x)) (* b x)))

(test-case "a map of the plane may be called H"
  (define p (find-fixed-point H (up 0.6 0.2)))
  (define x (/ (+ (- b 1) (sqrt (+ (expt (- 1 b) 2) (* 4 a)))) (* 2 a)))
  (check-= (abscissa (fixed-point-coordinates p)) x 1e-12))

(test-case "a tuple is no map of the plane"
  (check-exn #rx"^find-fixed-point: expected a map of the plane, or a function of a state"
             (lambda () (find-fixed-point (up 1 2) (up 0.6 0.2)))))

(test-case "a state derivative may take any number of arguments"
  (define (swing . states) (let ([s (car states)]) (up 1 (ref s 2) (- (ref s 1)))))
  (check-= (car (Lyapunov-values (Lyapunov-exponents swing (up 0 1.0 0.0) 20))) 0 1e-3))

;; To see which coordinates are angles it is done six times, where the point is and beside it; the
;; point is as near as one step goes.
(test-case "a map of states is done no more often than it must be"
  (define done 0)
  (define (halved s)
    (set! done (+ done 1))
    (up (time s) (* 1/2 (ref s 1)) (* 1/2 (ref s 2))))
  (find-fixed-point halved (up 0 0.05 0.05))
  (check-true (<= done 9)))
