#lang mechanics
;; Exercise 6.3 (SICM 6.1.3): the oscillator's generating function
;; Checked: the integral W, the transformation it makes, and F₂ against the action
;; How: derivatives of W, and the rate of F₂ along a motion beside the Lagrangian

;; With the amplitude A = √(2E/k): W = √(km)/2 (x √(A² − x²) + A² arcsin(x/A)).
(assume '(> m 0) '(> k 0) '(> A 0) '(> x 0) '(< x A))
(define (W x A)
  (* 1/2 (sqrt (* 'k 'm))
     (+ (* x (sqrt (- (square A) (square x))))
        (* (square A) (asin (/ x A))))))

(define momentum-right
  (verify-equal (((partial 0) W) 'x 'A) (* (sqrt (* 'm 'k)) (sqrt (- (square 'A) (square 'x))))))
momentum-right

;; ∂W/∂E with A = √(2E/k), so that dA/dE = 1/(kA)
(define time-right
  (verify-equal (/ (((partial 1) W) 'x 'A) (* 'k 'A)) (* (sqrt (/ 'm 'k)) (asin (/ 'x 'A)))))
time-right

;; Along a motion x = A sin ωt the rate of F₂ = W − E t is the Lagrangian.
(define omega (sqrt (/ 'k 'm)))
(define (x t) (* 'A (sin (* omega t))))
(define p-squared (* 'm 'k (- (square 'A) (square (x 't)))))
(define E (* 1/2 'k (square 'A)))
(define rate (- (/ p-squared 'm) E))            ; p Dx − E
(define L (- (* 1/2 'm (square ((D x) 't))) (* 1/2 'k (square (x 't)))))
(define action-right (verify-equal rate L))
action-right

;; The slip: W itself for the action.
(define slip (verify-equal (/ p-squared 'm) L))
(verdict-status slip)
(forget-assumptions)

(module+ test
  (require rackunit)
  (test-case "both halves of the transformation, and the action"
    (for ([v (list momentum-right time-right action-right)]) (check-pred proved? v)))
  (test-case "without −E t it is not the action"
    (check-pred refuted? slip)))
