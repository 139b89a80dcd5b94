#lang mechanics
;; Exercise 9.1 (SICM 9): the chain rule
;; Checked: the derivatives of functions of two numbers, and of their composition
;; How: against D, as functions of two arguments and, as exercise 9.2 has it, of a tuple

;; F is a function of two numbers, G one of two numbers that gives a tuple, and H is F after G.
(define (F x y) (* (square x) (cube y)))
(define (G x y) (up (F x y) y))
(define (H x y) (F (F x y) y))

((D F) 'x 'y)
((D G) 'x 'y)
((D H) 'x 'y)

;; By hand: ∂₀F = 2 x y³ and ∂₁F = 3 x² y².  The chain rule takes both at (F(x, y), y):
;;
;;     ∂₀H = ∂₀F(F, y) ∂₀F,    ∂₁H = ∂₀F(F, y) ∂₁F + ∂₁F(F, y)
(define (by-hand x y)
  (down (* 4 (cube x) (expt y 9)) (* 9 (expt x 4) (expt y 8))))
(define right (verify-equal ((D H) 'x 'y) (by-hand 'x 'y)))

;; Who forgets that y stands in H twice loses the second term of ∂₁H.
(define (forgetful x y)
  (down (* 4 (cube x) (expt y 9)) (* 6 (expt x 4) (expt y 8))))
(define wrong (verify-equal ((D H) 'x 'y) (forgetful 'x 'y)))
right
wrong

;; As functions of one tuple: the derivative of H is then a product, DH = (DF after G) DG.
(define (F-of-tuple (up x y)) (F x y))
(define (G-of-tuple (up x y)) (G x y))
(define H-of-tuple (compose F-of-tuple G-of-tuple))
(define chain
  (verify-equal ((D H-of-tuple) (up 'x 'y))
                (* ((D F-of-tuple) (G 'x 'y)) ((D G-of-tuple) (up 'x 'y)))))
chain

(module+ test
  (require rackunit)
  (test-case "the derivative of the composition"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-pred proved? chain))
  (test-case "numbers"
    (check-equal? ((D F) 2 3) (down 108 108))
    (check-equal? ((D G) 3 5) (down (up 750 0) (up 675 1)))))
