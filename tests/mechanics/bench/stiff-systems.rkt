#lang racket/base
;; The stiff and the constrained motions that are measured.

(require mechanics
         "motion-systems.rkt")

(provide stiff-motions projected-motions)

(define ((van-der-pol mu) (up t x v)) (up 1 v (- (* mu (- 1 (square x)) v) x)))

(define (Robertson (up t a b c))
  (define-values (slow fast back) (values (* 0.04 a) (* 3e7 b b) (* 1e4 b c)))
  (up 1 (- back slow) (- slow back fast) fast))

(define ((L-spring-pendulum k g) (up t (up r theta) (up rdot thetadot)))
  (- (+ (* 1/2 (+ (square rdot) (square (* r thetadot)))) (* g r (cos theta)))
     (* 1/2 k (square (- r 1)))))
(define ((loss c) (up t q (up rdot thetadot))) (* 1/2 c (square rdot)))

(define (stiff-motions)
  (append
   (list (motion "van der Pol, μ = 1000, to t = 2000, 1e-8" (van-der-pol 1000) (up 0.0 2.0 0.0)
                 2000.0 1e-8 0.0 #f)
         (motion "Robertson, to t = 1e11, 1e-8" Robertson (up 0.0 1.0 0.0 0.0) 1e11 1e-8 0.0 #f)
         (motion "spring pendulum, k = 1e10, to t = 3, 1e-8"
                 (Lagrangian->state-derivative (L-spring-pendulum 1e10 9.8) (loss 1e8))
                 (up 0.0 (up 1.0 1.0) (up 0.0 0.0)) 3.0 1e-8 0.0 #f))
   (for/list ([n '(8 20 40)])
     (motion (format "chain of ~a links, to t = 1, 1e-6" n) (released-chain n)
             (released-chain-start n) 1.0 1e-6 0.0 #f))))

;; n masses, each joined to the one before by a rod of length 1, released at 1 rad
(define ((rods n) t q)
  (vector->up (for/vector ([k n])
                (- (square (- (ref q k) (if (= k 0) (up 0 0) (ref q (- k 1))))) 1))))

(define ((L-masses n) (up t q v))
  (for/sum ([k n]) (- (* 1/2 (square (ref v k))) (* 9.8 (ref q k 1)))))

(define (projected-motions)
  (for/list ([n '(2 5 10 20)])
    (define (tuple f) (vector->up (build-vector n f)))
    (motion (format "~a rods, to t = 1, 1e-8" n)
            (constrained-state-derivative (L-masses n) (holonomic (rods n)))
            (up 0.0
                (tuple (lambda (k) (up (* (+ k 1) (sin 1.0)) (* -1 (+ k 1) (cos 1.0)))))
                (tuple (lambda (k) (up 0.0 0.0))))
            1.0 1e-8 0.0 #f)))
