#lang mechanics
;; A knife edge on an incline, x downhill: it moves along itself only. Its angle turns
;; steadily, and on average it does not go down at all.

(define ((L-edge m J g α) (up t (up x y θ) (up vx vy ω)))
  (+ (* 1/2 m (+ (square vx) (square vy))) (* 1/2 J (square ω)) (* m g x (sin α))))
(define blade
  (nonholonomic (lambda (t (up x y θ) (up vx vy ω)) (- (* vx (sin θ)) (* vy (cos θ))))))
(define L (L-edge 'm 'J 'g 'α))
(define q (up 'x 'y 'θ))

(Frobenius-test blade q)
(define solution
  ((constrained-accelerations L blade)
   (up 't q (up (* 'v (cos 'θ)) (* 'v (sin 'θ)) 'ω))))
solution

;; From rest, turned with ω.
(define (cycloid t)
  (define k (/ (* 'g (sin 'α)) (* 2 (square 'ω))))
  (define angle (* 'ω t))
  (up (* k (square (sin angle))) (* k (- angle (* (sin angle) (cos angle)))) angle))
(define motion (verify-solution L cycloid #:constraints blade))
motion

;; ẏ = ẋ tan θ substituted in L.
(define substituted
  (reduce-by-substitution L blade
                          (lambda (t (up x y θ) (up vx vy ω)) (up vx (* vx (tan θ)) ω))
                          (up 't q (up 'vx 'vy 'ω))))
substituted

(module+ test
  (require rackunit)
  (test-case "the knife edge is nonholonomic, and turns steadily"
    (check-eq? (verdict-status (Frobenius-test blade q)) 'refuted)
    (check-equal? (simplify (ref solution 0 2)) 0))
  (test-case "it moves on a cycloid"
    (check-eq? (verdict-status motion) 'proved))
  (test-case "the substituted Lagrangian is wrong"
    (check-eq? (verdict-status (reduction-agreement substituted)) 'refuted)))
