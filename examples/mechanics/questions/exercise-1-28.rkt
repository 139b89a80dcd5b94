#lang mechanics
;; Which of these are total time derivatives, and of what?  (SICM exercises 1.27 and 1.28)

(define line (up 't 'x 'v))
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))

;; The Lagrange equations of a total time derivative hold for all paths.
(define f (literal-function 'f (-> (UP Real (UP Real Real)) Real)))
(verify-total-time-derivative (Dt f) plane)

;; With a coefficient that changes in time, a velocity alone is none ...
(define (a (up t x v)) (* 'm v (sin (* 'omega t))))
(verify-total-time-derivative a line)

;; ... and needs a companion.  Is this it?
(define (b (up t x v)) (+ (* v (sin (* 'omega t))) (* x (cos (* 'omega t)))))
(verify-total-time-derivative b line)

;; Almost: the residual shows what the rate of the sine is.
(define (c (up t x v)) (+ (* v (sin (* 'omega t))) (* 'omega x (cos (* 'omega t)))))
((gauge-function c line) line)

;; In a plane the coefficients of the velocities must be a gradient.
(define (d (up t (up x y) (up vx vy))) (+ (* (square y) vx) (* 2 x y vy) (* (exp t) (+ y vy))))
((gauge-function d plane) plane)
(define (e (up t (up x y) (up vx vy))) (+ (* (square y) vx) (* x y vy)))
(verify-total-time-derivative e plane)

(module+ test
  (require rackunit)
  (define ((status-at local) F) (verdict-status (verify-total-time-derivative F local)))
  (test-case "which are"
    (check-equal? (map (status-at line) (list a b c)) '(refuted refuted proved))
    (check-equal? (map (status-at plane) (list (Dt f) d e)) '(proved proved refuted)))
  (test-case "the second one is if ω is 1"
    (check-equal? (map expression (verdict-conditions (verify-total-time-derivative b line)))
                  '((= omega 1))))
  (test-case "of what"
    (check-equal? (expression (simplify ((gauge-function c line) line))) '(* x (sin (* omega t))))
    (check-pred proved? (verify-equal ((gauge-function d plane) plane)
                                      (+ (* 'x (square 'y)) (* 'y (exp 't)))))))
