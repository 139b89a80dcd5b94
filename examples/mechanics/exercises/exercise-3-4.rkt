#lang mechanics
;; Exercise 3.4 (SICM 3.1.1): simple Legendre transforms
;; Checked: transforms of functions of one and of two active arguments
;; How: against Legendre-transform; gradients by active and by passive arguments

;; ---------------------------------------------------------------------------
;; F(x) = a x + b x²

(define (F x) (+ (* 'a x) (* 'b (square x))))
(define G (Legendre-transform F))

(define right (verify-equal (G 'w) (/ (square (- 'w 'a)) (* 4 'b))))
right

;; The slip: w x − F(x) with x = w/2b, as though there were no linear term.
(define slip (verify-equal (G 'w) (- (* 'w (/ 'w (* 2 'b))) (F (/ 'w (* 2 'b))))))
slip

;; x = DG(w), w = DF(x): the gradients are inverse functions.
(define inverse (verify-equal ((compose (D G) (D F)) 'x) 'x))
inverse

;; ---------------------------------------------------------------------------
;; F(x, y) = a sin x cos y, with x active.  Near x = 0, where a cos y = w/cos x:

(define (F-wave x y) (* 'a (sin x) (cos y)))
(define (G-wave w y)
  (define x (acos (/ w (* 'a (cos y)))))
  (- (* w x) (F-wave x y)))

;; There is no formula that the library would find; the relations decide.
(define active (verify-equal (((partial 0) G-wave) 'w 'y) (acos (/ 'w (* 'a (cos 'y))))))
(define passive
  (prove-zero (+ (((partial 1) G-wave) 'w 'y)
                 (((partial 1) F-wave) (acos (/ 'w (* 'a (cos 'y)))) 'y))))
active
passive

;; ---------------------------------------------------------------------------
;; F(x, y, ẋ, ẏ) = x ẋ² + 3 ẋ ẏ + y ẏ², with the velocities active

(define ((F-form x y) (up vx vy)) (+ (* x (square vx)) (* 3 vx vy) (* y (square vy))))
(define (attempt wx wy)
  (/ (+ (* 'y (square wx)) (* -3 wx wy) (* 'x (square wy)))
     (- (* 4 'x 'y) 9)))
(define form (verify-equal ((Legendre-transform (F-form 'x 'y)) (down 'w_x 'w_y))
                           (attempt 'w_x 'w_y)))
form

;; Where 4xy = 9 there is none: two velocities share a momentum.
(define (no-transform)
  ((Legendre-transform (F-form 3/2 3/2)) (down 'w_x 'w_y)))

(module+ test
  (require rackunit)
  (test-case "the transforms"
    (for ([v (list right inverse active passive form)]) (check-pred proved? v)))
  (test-case "a linear term that was left out is seen, and that it is all"
    (check-pred refuted? slip)
    (check-pred proved? (verify-equal (verdict-residual slip) (/ (square 'a) (* 4 'b)))))
  (test-case "a form that is no longer invertible is named with its direction"
    (check-exn #rx"no inertia in the direction: [(]up -1 1[)]" no-transform)))
