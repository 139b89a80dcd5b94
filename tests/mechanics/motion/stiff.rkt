#lang racket/base
;; Stiff systems, with derivatives made for them.

(require mechanics "../support/checks.rkt")

;; A pendulum in a thick fluid.  After the first moment v = -(g/mu) sin(theta) nearly,
;; so that tan(theta/2) falls as exp(-g t/mu).
(define ((in-honey mu g) (up t theta v))
  (up 1 v (- (* -1 g (sin theta)) (* mu v))))

;; The same, written so that it cannot be traced.
(define ((in-honey/branch mu g) (up t theta v))
  (up 1 v (- (if (> theta 0) (* -1 g (sin theta)) (* g (sin (- theta)))) (* mu v))))

(define start (up 0 1 0))
(define slow (* 2 (atan (* (tan 0.5) (exp (- (/ (* 9.8 100) 1e4)))))))

(define (check-slow s)
  (check-equal? (ref s 0) 100.0)
  (check-= (ref s 1) slow 1e-5)
  (check-= (ref s 2) (/ (* -9.8 (sin slow)) 1e4) 1e-8))

(test-case "the same motion with parameters, without them, and without a trace"
  (define with-parameters
    ((state-advancer in-honey 1e4 9.8) start 100 1e-9 #:method 'Radau-IIA-5))
  (check-slow with-parameters)
  (for ([f (list (in-honey 1e4 9.8) (in-honey/branch 1e4 9.8))])
    (define tr (evolve-trajectory f start 100 #:tolerance 1e-9 #:method 'Radau-IIA-5))
    (check-true (< (length (trajectory-states tr)) 300))
    (check-slow (trajectory-final-state tr))
    (check-= (ref (trajectory-final-state tr) 1) (ref with-parameters 1) 1e-9)))

(test-case "backwards, where it is unstable, a short way"
  (define advance (state-advancer in-honey 100 9.8))
  (define there (advance start 0.1 1e-10 #:method 'Radau-IIA-5))
  (check-= (ref (advance there -0.1 1e-10 #:method 'Radau-IIA-5) 1) 1 1e-5))

(test-case "mildly stiff or not at all, it agrees with the default method"
  (define ((van-der-pol mu) (up t x v)) (up 1 v (- (* mu (- 1 (square x)) v) x)))
  (for ([mu '(0.1 5)])
    (define (final method)
      ((state-advancer van-der-pol mu) (up 0 2 0) 10 1e-10 #:method method))
    (check-= (ref (final 'Radau-IIA-5) 1) (ref (final 'Dormand-Prince-853) 1) 1e-8)))
