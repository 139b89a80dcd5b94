#lang mechanics
;; A wheel that rolls upright on an incline, y uphill: φ is the angle of rolling, θ the
;; direction. From its equations follows 2 m R² φ̈ = −m g sin α R cos θ; a lecture note in
;; circulation prints a plus.

(define ((L-wheel m R g α) (up t (up x y φ θ) (up vx vy vφ vθ)))
  (- (+ (* 1/2 m (+ (square vx) (square vy)))
        (* 1/2 m (square R) (square vφ)) (* 1/4 m (square R) (square vθ)))
     (* m g y (sin α))))
(define ((rolling-x R) t (up x y φ θ) (up vx vy vφ vθ)) (- vx (* R (sin θ) vφ)))
(define ((rolling-y R) t (up x y φ θ) (up vx vy vφ vθ)) (- vy (* R (cos θ) vφ)))
(define L (L-wheel 'm 'R 'g 'α))
(define rolling (list (nonholonomic (rolling-x 'R)) (nonholonomic (rolling-y 'R))))

(define q (up 'x 'y 'φ 'θ))
(define (rolling-velocity t (up x y φ θ) (up vx vy vφ vθ))
  (up (* 'R (sin θ) vφ) (* 'R (cos θ) vφ) vφ vθ))
(define state (up 't q (up 'vx 'vy 'vφ 'vθ)))
(define solution
  ((constrained-accelerations L rolling) (up 't q (rolling-velocity 't q (velocity state)))))
solution

(define φ-acceleration (ref solution 0 2))
(define weight (* 'm 'g (sin 'α) 'R (cos 'θ)))
(define printed (verify-equal (* 2 'm (square 'R) φ-acceleration) weight))
printed
(define corrected (verify-equal (* 2 'm (square 'R) φ-acceleration) (- weight)))
corrected

;; Substituting the constraints in the Lagrangian loses gravity in φ; with the multiplier of
;; one of them kept it happens to be right, though it is no valid step.
(define both (reduce-by-substitution L rolling rolling-velocity state))
both
(define one-kept
  (reduce-by-substitution L rolling rolling-velocity state
                          #:keep (nonholonomic (rolling-y 'R))))
one-kept

(module+ test
  (require rackunit)
  (test-case "the sign in circulation is refuted, the other proved"
    (check-eq? (verdict-status printed) 'refuted)
    (check-true (pair? (verdict-witness printed)))
    (check-eq? (verdict-status corrected) 'proved))
  (test-case "the wheel keeps turning steadily"
    (check-equal? (simplify (ref solution 0 3)) 0))
  (test-case "substitution: refuted, and right by accident"
    (check-eq? (verdict-status (reduction-agreement both)) 'refuted)
    (check-eq? (verdict-status (reduction-agreement one-kept)) 'proved)
    (check-eq? (verdict-status (reduction-integrability both)) 'refuted)))
