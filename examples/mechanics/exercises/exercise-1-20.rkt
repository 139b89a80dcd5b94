#lang mechanics
;; Exercise 1.20 (SICM 1.6.2): a pendulum on a sliding support
;; Checked: both equations of motion
;; How: against the residuals of the Lagrangian that the coordinates give

;; A support of mass m_1 slides along a level rail; a pendulum of length l with a bob of mass
;; m_2 hangs from it.  What are the equations of motion?

(require mechanics/book)

(define x (literal-function 'x))
(define theta (literal-function 'theta))
(define residual
  (((Lagrange-equations (L-sliding-pend 'm_1 'm_2 'l 'g)) (up x theta)) 't))

;; The first says that the momentum along the rail does not change; the second is a
;; pendulum's, in a frame that is accelerated with its support.
(define (equations momentum)
  (down ((D momentum) 't)
        (* 'm_2 'l (+ (* 'l (((expt D 2) theta) 't))
                      (* (cos (theta 't)) (((expt D 2) x) 't))
                      (* 'g (sin (theta 't)))))))

(define of-both
  (+ (* (+ 'm_1 'm_2) (D x)) (* 'm_2 'l (compose cos theta) (D theta))))
(define right (verify-equal residual (equations of-both)))
right

;; The slip forgets that the bob is carried along, too.
(define of-support
  (+ (* 'm_1 (D x)) (* 'm_2 'l (compose cos theta) (D theta))))
(define wrong (verify-equal residual (equations of-support)))
wrong

(module+ test
  (require rackunit)
  (test-case "momentum along the rail and an accelerated pendulum"
    (check-pred proved? right))
  (test-case "the missing term is the bob's"
    (check-pred refuted? wrong)
    (check-equal? (expression (verdict-residual wrong))
                  '(down (* m_2 (((expt D 2) x) t)) 0))))
