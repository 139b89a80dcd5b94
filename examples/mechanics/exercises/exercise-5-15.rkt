#lang mechanics
;; Exercise 5.15 (SICM 5.4.5): a generating function of the standard map
;; Checked: F(θ, θ') against the map
;; How: the transformation it generates, and a verdict on its derivatives

;; Find a function of the old and the new angle that generates the standard map,
;; I' = I + K sin θ, θ' = θ + I'.

(define state (up 't 'theta 'I))
(define (standard-map state)
  (define-values (theta I) (values (coordinate state) (momentum state)))
  (define I-new (+ I (* 'K (sin theta))))
  (up (time state) (+ theta I-new) I-new))

;; With I' = θ' − θ and I = θ' − θ − K sin θ: I' = ∂F/∂θ' and I = −∂F/∂θ.
;; The map goes from the state to its image, the image is "old".
(define (F t image theta)
  (+ (* 1/2 (square (- image theta))) (* 'K (cos theta) -1)))
(define right (verify-generating-function standard-map F state))
right
(define generated (verify-equal ((F1->C F) state) (standard-map state)))
generated

;; The slip: the sign of the kick.
(define (slip-F t image theta)
  (+ (* 1/2 (square (- image theta))) (* 'K (cos theta))))
(define slip (verify-generating-function standard-map slip-F state))
(verdict-residual slip)

(module+ test
  (require rackunit)
  (test-case "it generates the map"
    (check-pred proved? right)
    (check-pred proved? generated))
  (test-case "with the other sign the kick is missed twice"
    (check-pred refuted? slip)
    (check-pred proved? (verify-equal (verdict-residual slip)
                                      (up 0 (* 2 'K (sin 'theta)))))))
