#lang mechanics
;; The group of rotations as a manifold: bodies that pass through θ = 0, where Euler's angles are
;; singular and the motion is not.

(require mechanics/geometry)

;; A free body with three moments, turning at first about the line of nodes: θ goes from 0.5 to 0
;; and beyond.
(define L (T-rigid-body 1 2 3))
(define start (up 0 (up 0.5 0.2 0.) (up -1. 0.01 0.)))
(define body (evolve-on L Euler-angles start 20 #:tolerance 1e-13))
(map caddr (trajectory-chart-changes body))

;; The same by quaternions, which are singular nowhere
(define by-quaternions
  (evolve-trajectory (qw-sysder 1 2 3)
                     (up 0 (quaternion->vector (rotation-matrix->quaternion
                                                (Euler->M (coordinate start))))
                         (Euler-state->omega-body start))
                     20 #:tolerance 1e-13))
(define (M-of-angles t) (Euler->M (coordinate (body t))))
(define (M-of-quaternion t)
  (quaternion->rotation-matrix (make-quaternion (ref (by-quaternions t) 1))))
(define (off t)
  (define-values (a b) (values (M-of-angles t) (M-of-quaternion t)))
  (for*/fold ([most 0]) ([i 3] [j 3]) (max most (abs (- (matrix-ref a i j) (matrix-ref b i j))))))
(for/and ([t 21]) (< (off t) 1e-10))

;; Momenta along the motion: p_φ, about the vertical, is conserved.
(define momenta (for/list ([t '(0 5 10 15 20)]) (ref (trajectory-momentum body t) 1)))
momenta

;; A top that rises to the vertical and falls on the other side: p_φ = p_ψ.
(define ((L-top A C gMR) local)
  (- ((T-rigid-body A A C) local) (* gMR (cos (ref (coordinate local) 0)))))
(define-values (A C gMR tilt spin) (values 1 0.5 1 0.4 1.))
(define precession (/ (* C spin) (- (* A (+ 1 (cos tilt))) (* C (cos tilt)))))
(define top
  (evolve-on (L-top A C gMR) Euler-angles (up 0 (up tilt 0. 0.) (up -2. precession spin)) 10
             #:tolerance 1e-12))
(length (trajectory-chart-changes top))
(apply min (for/list ([t (in-range 0 10 0.01)]) (ref (coordinate (top t)) 0)))

(module+ test
  (require rackunit)
  (test-case "as by quaternions" (for ([t 21]) (check-= (off t) 0 1e-10)))
  (test-case "p_φ stays" (for ([p momenta]) (check-= p (car momenta) 1e-11))))
