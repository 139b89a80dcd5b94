#lang racket/base
;; Systems whose motions several files follow, and how states are compared.

(require (except-in rackunit fail)
         mechanics)

(provide check-state exact
         driven-pendulum L-double-pendulum L-chain)

;; given, expected : structures or lists, of numbers of any precision
(define-check (check-state given expected tolerance)
  (define xs (scalars-of given))
  (define ys (scalars-of expected))
  (unless (and (= (length xs) (length ys))
               (for/and ([x xs] [y ys]) (< (abs (- (exact x) (exact y))) tolerance)))
    (with-check-info (['given given] ['expected expected]) (fail-check))))

(define (scalars-of s)
  (cond [(structure? s) (scalars-of (structure->list s))]
        [(list? s) (apply append (map scalars-of s))]
        [else (list s)]))

(define (exact x) (if (bigfloat? x) (bigfloat->exact x) (inexact->exact x)))

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
