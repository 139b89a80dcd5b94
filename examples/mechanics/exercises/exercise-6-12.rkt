#lang mechanics
;; Exercise 6.12 (SICM 6.7): symplectic integration
;; Checked: the orders of two maps for Hénon and Heiles, and that regular orbits stay regular
;; How: exponentials of operators, errors of steps and of energies, a section

(require mechanics/book mechanics/plot)

;; H₀, two oscillators, turns each plane; H₁ changes momenta alone.
(define (H-1 s)
  (define-values (x y) (values (ref s 1 0) (ref s 1 1)))
  (- (* (square x) y) (* 1/3 (cube y))))
(define (turn (up t (up x y) (down p_x p_y)) dt)
  (define-values (c s) (values (cos dt) (sin dt)))
  (up (+ t dt)
      (up (+ (* c x) (* s p_x)) (+ (* c y) (* s p_y)))
      (down (- (* c p_x) (* s x)) (- (* c p_y) (* s y)))))
(define (kick s dt) (up (time s) (coordinate s) (- (momentum s) (* dt (((partial 1) H-1) s)))))

(define (first-order-map s dt) (kick (turn s dt) dt))
(define (second-order-map s dt) (turn (kick (turn s (/ dt 2)) dt) (/ dt 2)))
(define state (up 't (up 'x 'y) (down 'p_x 'p_y)))
(define symplectic
  (for/list ([step (list first-order-map second-order-map)])
    (verify-symplectic (lambda (s) (step s 'dt)) state)))
symplectic

;; a, b. exp A exp B begins to differ from exp(A + B) in the second order, by [A, B]/2;
;; exp(A/2) exp B exp(A/2) in the third.
(define (any name) (literal-function name (Hamiltonian 1)))
(define-values (A B F) (values (Lie-derivative (any 'f)) (Lie-derivative (any 'g)) (any 'F)))
(define line (up 't 'q 'p))
(define half (exp (* 1/2 A)))
(define (second-term G) (series:ref (G line) 2))
(define together (second-term ((exp (+ A B)) F)))
(define symmetric (verify-equal (second-term (half ((exp B) (half F)))) together))
symmetric
;; The slip: that the first map is as good.
(define slip (verify-equal (second-term ((exp A) ((exp B) F))) together))
(verdict-status slip)

;; c, d. Errors of one step, and of the energy in a long time, with the step halved
(define start (section->state 1/12 0.1 0.))
(define advance (state-advancer HHsysder))
(define (step-error step dt)
  (define difference (- (step start dt) (advance start dt 1e-14)))
  (+ (abs (ref difference 1 0)) (abs (ref difference 2 0)) (abs (ref difference 2 1))))
(define (energy-error step dt)
  (for/fold ([s start] [worst 0.] #:result worst) ([_ (in-range 0 60 dt)])
    (define next (step s dt))
    (values next (max worst (abs (- (HHHam next) 1/12))))))
(define (order error step dt) (/ (log (/ (error step dt) (error step (/ dt 2)))) (log 2)))
(define orders
  (for*/list ([error (list step-error energy-error)]
              [step (list first-order-map second-order-map)])
    (order error step 0.1)))
orders

;; e. The section by the second map
(define win (frame -0.6 0.8 -0.6 0.6))
(explore-map win (HH-collector win second-order-map 1/12 0.1 1e-10 60) #f
             #:starts (list (up 0.1 0.)))

(module+ test
  (require rackunit)
  (test-case "both are symplectic"
    (for ([v symplectic]) (check-pred proved? v)))
  (test-case "orders, by operators"
    (check-pred proved? symmetric)
    (check-pred refuted? slip))
  (test-case "orders, by numbers: of a step one more than of what is kept"
    (for ([found orders] [expected '(2 3 1 2)]) (check-= found expected 0.2)))
  (test-case "the energy error does not grow"
    (check-true (< (energy-error second-order-map 0.1) 2e-4)))
  (test-case "crossings are near the curve of the motion itself"
    (define exact (frame -0.6 0.8 -0.6 0.6))
    (explore-map exact (HHmap 1/12 0.1 1e-10 1e-11) 60 #:starts (list (up 0.1 0.)))
    (define (extent f) (apply max (map (lambda (p) (ref p 0)) (frame-points f))))
    (check-= (extent win) (extent exact) 0.01)))
