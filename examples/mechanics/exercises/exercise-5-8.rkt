#lang mechanics
;; Exercise 5.8 (SICM 5.2): the standard map is symplectic
;; Checked: the brackets of its two coordinates
;; How: a verdict for any kick, and for one taken at the old angle

;; I' = I + K sin θ and θ' = θ + I': show that it keeps areas.

(define state (up 't 'theta 'I))
(define ((kicked kick) state)
  (define-values (theta I) (values (coordinate state) (momentum state)))
  (define I-new (+ I (kick theta)))
  (up (time state) (+ theta I-new) I-new))

(define standard (verify-canonical (kicked (lambda (theta) (* 'K (sin theta)))) state))
standard
(define right (verify-canonical (kicked (literal-function 'f)) state))
right

;; The slip: the angle moves by the momentum before the kick.
(define (slip-map state)
  (define-values (theta I) (values (coordinate state) (momentum state)))
  (up (time state) (+ theta I) (+ I (* 'K (sin theta)))))
(define slip (verify-canonical slip-map state))
slip

(module+ test
  (require rackunit)
  (test-case "whatever the kick"
    (check-pred proved? standard)
    (check-pred proved? right))
  (test-case "not with both from the old state"
    (check-pred refuted? slip)
    (check-equal? (verdict-conditions slip) '((= K 0)))))
