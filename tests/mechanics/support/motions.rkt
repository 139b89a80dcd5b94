#lang racket/base
;; Systems whose motions several files follow.

(require (except-in rackunit fail)
         mechanics)

(provide driven-pendulum L-double-pendulum L-chain)

;; ---------------------------------------------------------------------------

;; A state derivative: the pivot moves as a cos ωt (1.6.2).
(define (driven-pendulum m l g a ω)
  (Lagrangian->state-derivative
   (L-driven-pendulum m l g (lambda (t) (* a (cos (* ω t)))))))

(define ((L-driven-pendulum m l g ys) (up t θ v))
  (+ (* 1/2 m (+ (square (* l v)) (square ((D ys) t)) (* 2 l v ((D ys) t) (sin θ))))
     (* m g l (cos θ))
     (- (* m g (ys t)))))

(define ((L-double-pendulum m1 m2 l1 l2 g) (up t (up a b) (up va vb)))
  (+ (* 1/2 (+ m1 m2) (square (* l1 va)))
     (* 1/2 m2 (square (* l2 vb)))
     (* m2 l1 l2 va vb (cos (- a b)))
     (* (+ m1 m2) g l1 (cos a))
     (* m2 g l2 (cos b))))

;; n links of length 1 with masses 1 at their ends, hanging from one another.
(define (L-chain n g)
  (compose (lambda (s)
             (for/sum ([r (coordinate s)] [v (velocity s)])
               (- (* 1/2 (square v)) (* g (ref r 1)))))
           (F->C (chain n))))

(define ((chain n) s)
  (define θ (coordinate s))
  (define-values (points x y)
    (for/fold ([points '()] [x 0] [y 0]) ([i n])
      (let ([x (+ x (sin (ref θ i)))] [y (- y (cos (ref θ i)))])
        (values (cons (up x y) points) x y))))
  (apply up (reverse points)))
