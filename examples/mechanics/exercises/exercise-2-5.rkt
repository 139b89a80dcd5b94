#lang mechanics
;; Exercise 2.5 (SICM 2.5): a constraint on the moments of inertia
;; Checked: that the sum of two moments is at least the third
;; How: the difference of both sides, as a sum of squares

;; Show that of three moments of inertia about perpendicular axes none is greater than the sum of
;; the two others.

(define I (inertia-tensor '(m_1 m_2) (list (up 'x_1 'y_1 'z_1) (up 'x_2 'y_2 'z_2))))
(define (moment i) (matrix-ref I i i))

;; The surplus of two of them over the third.
(define surplus (- (+ (moment 0) (moment 1)) (moment 2)))
surplus

(define attempt (* 2 (+ (* 'm_1 (square 'z_1)) (* 'm_2 (square 'z_2)))))
(define right (verify-equal surplus attempt))
right

;; A slip that looks alike: the third moment's own coordinates.
(define slip (* 2 (+ (* 'm_1 (square 'x_1)) (* 'm_2 (square 'x_2)))))
(define wrong (verify-equal surplus slip))
(verdict-status wrong)

;; It vanishes for what is flat: a plate in the plane of x and y.
(define flat (substitute surplus 'z_1 0 'z_2 0))
(simplify flat)

;; The axes need not be principal ones; and no body has these moments:
(define (possible? A B C) (and (>= (+ A B) C) (>= (+ B C) A) (>= (+ C A) B)))
(possible? 1 2 3)
(possible? 1 1 3)

(module+ test
  (require rackunit)
  (test-case "what is beyond is a sum of squares with positive masses"
    (check-pred proved? right)
    (check-pred refuted? wrong))
  (test-case "a flat body has nothing beyond"
    (check-equal? (simplify flat) 0))
  (test-case "which moments there are"
    (check-true (possible? 1 2 3))
    (check-false (possible? 1 1 3))))
