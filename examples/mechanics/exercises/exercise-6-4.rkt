#lang mechanics
;; Exercise 6.4 (SICM 6.1.4): uniform acceleration
;; Checked: the action between two places, and the evolution that it generates
;; How: Hamilton and Jacobi at both ends, a generated transformation against the motion

;; A particle of mass m with the acceleration a.
(define ((falling m a) (up t q p)) (- (/ (square p) (* 2 m)) (* m a q)))
(define H (falling 'm 'a))

;; The action from q₁ at t₁ to q₂ at t₂, with T = t₂ − t₁:
;;   m (q₂ − q₁)²/(2T) + m a T (q₁ + q₂)/2 − m a² T³/24
(define (F t1 q1 t2 q2)
  (define T (- t2 t1))
  (- (+ (/ (* 'm (square (- q2 q1))) (* 2 T)) (* 1/2 'm 'a T (+ q1 q2)))
     (/ (* 'm (square 'a) (cube T)) 24)))

;; It is the action of the path there.
(define ((path q1 v) t) (+ q1 (* v t) (* 1/2 'a (square t))))
(define ((L m a) (up t q v)) (+ (* 1/2 m (square v)) (* m a q)))
(define along (compose (L 'm 'a) (Gamma (path 'q_1 'v))))
(define computed ((D (lambda (T) (F 0 'q_1 T ((path 'q_1 'v) T)))) 'T))
(define action (verify-equal computed (along 'T)))
action

;; Its rates by the second time and place solve the equation, and it moves states on.
(define equation (verify-Hamilton-Jacobi H (lambda (t q) (F 't_1 'q_1 t q)) 't 'q))
equation
(define evolved ((F1->C (lambda (t q q1) (F 0 q1 t q))) (up 'T 'q_1 'p_1)))
(define evolution
  (verify-equal evolved
                (up 'T
                    (+ 'q_1 (* (/ 'p_1 'm) 'T) (* 1/2 'a (square 'T)))
                    (+ 'p_1 (* 'm 'a 'T)))))
evolution

;; b. The constant of W = ∫ p dq is taken to be the energy E; the action is a difference of two
;; values of F₂ = W − E t with E such that both give the same new coordinate.
(define (half q E) (/ (expt (* 2 'm (+ E (* 'm 'a q))) 3/2) (* 3 (square 'm) 'a)))
(define solved
  (assuming ('(> m 0) '(> a 0) '(> q 0) '(> E 0))
    (verify-Hamilton-Jacobi H (lambda (t q) (- (half q 'E) (* 'E t))) 't 'q)))
solved
;; From q = 0 with the velocity 1 for a time of 1, m = a = 1: E = 1/2
(define (in-numbers e) (substitute e 'm 1 'a 1))
(list (in-numbers (F 0 0 1 3/2)) (in-numbers (- (half 3/2 1/2) (half 0 1/2) 1/2)))

;; The slip: no term of the third power of the time.
(define (slip-F t1 q1 t2 q2) (+ (F t1 q1 t2 q2) (/ (* 'm (square 'a) (cube (- t2 t1))) 24)))
(define slip (verify-Hamilton-Jacobi H (lambda (t q) (slip-F 't_1 'q_1 t q)) 't 'q))
(verdict-residual slip)

(module+ test
  (require rackunit)
  (test-case "the action, its equation, and the evolution"
    (for ([v (list action equation evolution solved)]) (check-pred proved? v)))
  (test-case "the action as a difference"
    (check-= (in-numbers (F 0 0 1 3/2)) (in-numbers (- (half 3/2 1/2) (half 0 1/2) 1/2)) 1e-14))
  (test-case "without the last term the energy is missed"
    (check-pred refuted? slip)))
