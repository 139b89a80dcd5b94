#lang mechanics
;; Forces as the coordinates see them: Q_j = Σ F·∂r/∂q_j.

(define ((pendulum l) t theta) (up (* l (sin theta)) (* -1 l (cos theta))))
(define (polar t (up r theta)) (up (* r (cos theta)) (* r (sin theta))))
(define swinging (up 't 'theta 'thetadot))
(define turning (up 't (up 'r 'theta) (up 'rdot 'thetadot)))

;; Gravity turns a pendulum back.
(define ((weight m g) t r v) (up 0 (* -1 m g)))
((generalized-force (pendulum 'l) (weight 'm 'g)) swinging)

;; The force that belongs to an angle is a torque, x F_y − y F_x.
(define (any-force t r v) (up 'F_x 'F_y))
(define torque (ref ((generalized-force polar any-force) turning) 1))
torque
(verify-equal torque (let ([x (* 'r (cos 'theta))] [y (* 'r (sin 'theta))])
                       (- (* x 'F_y) (* y 'F_x))))

;; Viscous drag −b v in polar coordinates.
(define ((drag b) t r v) (* -1 b v))
((generalized-force polar (drag 'b)) turning)

;; A force from a potential gives −∂U/∂q_j, whatever the potential and the coordinates.
(define V (literal-function 'V (-> (X Real (UP Real Real)) Real)))
(define r (literal-function 'r (-> (X Real (UP Real Real)) (UP Real Real))))
(define (U local) (V (time local) (r (time local) (coordinate local))))
(verify-equal ((generalized-force r (potential->force V)) (up 't (up 'a 'b) (up 'u 'v)))
              (- (((partial 1) U) (up 't (up 'a 'b) (up 'u 'v)))))

(module+ test
  (require rackunit)
  (define-syntax-rule (check-same a b) (check-true (proved? (verify-equal a b))))
  (test-case "gravity on a pendulum"
    (check-same ((generalized-force (pendulum 'l) (weight 'm 'g)) swinging)
                (* -1 'm 'g 'l (sin 'theta))))
  (test-case "drag in polar coordinates"
    (check-same ((generalized-force polar (drag 'b)) turning)
                (down (* -1 'b 'rdot) (* -1 'b (square 'r) 'thetadot))))
  (test-case "a torque"
    (check-same torque (* 'r (- (* 'F_y (cos 'theta)) (* 'F_x (sin 'theta)))))))
