#lang mechanics
;; Exercise 5.9 (SICM 5.2.2): Whittaker's transformation
;; Checked: that it is symplectic
;; How: a verdict, and the function of q and p' that generates it

;; q = log(sin p'/q') and p = q' cot p'.

(define state (up 't 'Q 'P))
(define (Whittaker state)
  (define-values (Q P) (values (coordinate state) (momentum state)))
  (up (time state) (log (/ (sin P) Q)) (* Q (cot P))))

(define right (verify-symplectic Whittaker state))
right

;; With q' = exp(−q) sin p' both p = ∂F/∂q and q' = ∂F/∂p' are derivatives of one function.
(define (F2 t q P) (* -1 (exp (- q)) (cos P)))
(define generated (verify-generating-function Whittaker F2 state #:type 2))
generated

;; The slip: the tangent for the cotangent.
(define (slip-transformation state)
  (define-values (Q P) (values (coordinate state) (momentum state)))
  (up (time state) (log (/ (sin P) Q)) (* Q (tan P))))
(define slip (verify-symplectic slip-transformation state))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "it is, and is generated"
    (check-pred proved? right)
    (check-pred proved? generated))
  (test-case "not with the tangent"
    (check-pred refuted? slip)))
