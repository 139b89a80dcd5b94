#lang mechanics
;; Exercise 5.14 (SICM 5.4.5): areas of parallelograms
;; Checked: that a linear canonical transformation keeps the sum of projected areas alone
;; How: for any parallelogram at the origin, and the area of one

(define (F1 t x x-prime)
  (+ (* (ref x-prime 0) (+ (* 'a (ref x 0)) (* 'b (ref x 1))))
     (* (ref x-prime 1) (+ (* 'c (ref x 0)) (* 'd (ref x 1))))))
(define C (F1->C F1))

;; b. The sides are two increments of the state; the sum of the areas of their projections on the
;; planes of x and p is ω.
(define (side k)
  (define (named x) (string->symbol (format "~a~a" x k)))
  (up 0 (up (named 'x_1) (named 'x_2)) (down (named 'p_1) (named 'p_2))))
(define-values (A B) (values (side 'a) (side 'b)))
(define (projected-areas A B)
  (for/sum ([i 2])
    (- (* (ref (coordinate A) i) (ref (momentum B) i))
       (* (ref (momentum A) i) (ref (coordinate B) i)))))
(define right (verify-equal (projected-areas (C A) (C B)) (projected-areas A B)))
right

;; a. The area itself, by Lagrange's identity, is another after it. Here x' = x stretched twofold
;; and p pressed, with sides along x₁ and x₂, whose projections have no areas.
(define (area A B)
  (define-values (u v) (values (scalars-of A) (scalars-of B)))
  (sqrt (- (* (square u) (square v)) (square (dot-product u v)))))
(define (scalars-of s)
  (up (ref s 1 0) (ref s 1 1) (ref s 2 0) (ref s 2 1)))
(define (numbers x) (simplify (substitute x 'a 2 'b 0 'c 0 'd 2)))
(define-values (e1 e2) (values (up 0 (up 1 0) (down 0 0)) (up 0 (up 0 1) (down 0 0))))
(define areas (list (area e1 e2) (area (numbers (C e1)) (numbers (C e2)))))
areas

;; The slip: that each projection is kept by itself.
(define (projection A B i)
  (- (* (ref (coordinate A) i) (ref (momentum B) i))
     (* (ref (momentum A) i) (ref (coordinate B) i))))
(define slip (verify-equal (projection (C A) (C B) 0) (projection A B 0)))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "the sum is kept, the area is not"
    (check-pred proved? right)
    (check-equal? (car areas) 1)
    (check-false (equal? (cadr areas) 1)))
  (test-case "nor is one projection"
    (check-pred refuted? slip)))
