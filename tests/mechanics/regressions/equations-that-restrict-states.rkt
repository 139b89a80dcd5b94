#lang racket/base
;; Of Lagrangians without inertia in some direction, the equations restrict states.  Those of
;; any two passed for equivalent, and quantities that their motions keep were refuted.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define plane (up 't (up 'x 'y) (up 'vx 'vy)))

;; y is where V says, without inertia.
(define ((L-light V) (up t (up x y) (up vx vy))) (- (* 1/2 (square vx)) (V y)))

;; Hamilton's equations, x being the momentum of y.
(define ((L-first-order H) (up t (up x y) (up vx vy))) (- (* x vy) (H x y)))
(define (H x y) (+ (square x) (square y)))
(define (other-H x y) (+ (square x) (* 2 (square y))))

(define restricted
  (string-append
   ": the equations of both Lagrangians restrict coordinates and velocities\n"
   "  such equations are compared only where the ones are a constant multiple of the others\n"
   "  residuals: "))

(test-case "motions at different places are not taken for the same"
  (check-message
   (string-append "compare-Lagrangians" restricted
                  "(down xddot y)\n             (down xddot (- y 1))")
   (compare-Lagrangians (L-light (lambda (y) (* 1/2 (square y))))
                        (L-light (lambda (y) (* 1/2 (square (- y 1)))))
                        plane)
   exn:fail:mechanics?)
  (check-message
   (string-append "verify-equivalent-Lagrangians" restricted
                  "(down (- (* 2 x) vy) (+ vx (* 2 y)))\n"
                  "             (down (- (* 2 x) vy) (+ vx (* 4 y)))")
   (verify-equivalent-Lagrangians (L-first-order H) (L-first-order other-H) plane)
   exn:fail:mechanics?))

(test-case "without accelerations nothing is refuted"
  (check-regexp-match
   #rx"^Lagrangian->acceleration: the mass matrix has no inverse; .*direction: .up 0 1."
   (message-of (verify-conserved (L-light square) (compose (component 1) coordinate) plane)
               exn:fail:mechanics?)))

(test-case "multiples and total derivatives are found still"
  (define L (L-first-order H))
  (check-eq? (equivalence-kind (compare-Lagrangians L (* 3 L) plane)) 'proportional)
  (check-eq? (equivalence-kind
              (compare-Lagrangians L (+ L (Dt (compose (component 0) coordinate))) plane))
             'total-derivative))

(test-case "one that restricts states is none that does not"
  (define (L-free (up t q v)) (* 1/2 (square v)))
  (check-pred refuted? (verify-equivalent-Lagrangians L-free (L-first-order H) plane))
  (check-pred refuted? (verify-equivalent-Lagrangians (L-first-order H) L-free plane)))

(test-case "the energy of equations of first order is conserved"
  (define L (L-first-order H))
  (check-pred proved? (verify-conserved L (Lagrangian->energy L) plane)))
