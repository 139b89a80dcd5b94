#lang racket/base
;; A wheel and a knife edge on an incline: what circulates about them, proved and refuted.

(require mechanics
         "../support/checks.rkt" "../support/session.rkt")

(define-syntax-rule (check-proved verdict) (check-eq? (verdict-status verdict) 'proved))
(define-syntax-rule (check-refuted verdict) (check-eq? (verdict-status verdict) 'refuted))

;; ---------------------------------------------------------------------------
;; The wheel: place x and y, y uphill, angle φ of rolling, direction θ

(define ((L-wheel m R g α) (up t (up x y φ θ) (up vx vy vφ vθ)))
  (- (+ (* 1/2 m (+ (square vx) (square vy)))
        (* 1/2 m (square R) (square vφ)) (* 1/4 m (square R) (square vθ)))
     (* m g y (sin α))))
(define ((rolling-x R) t (up x y φ θ) (up vx vy vφ vθ)) (- vx (* R (sin θ) vφ)))
(define ((rolling-y R) t (up x y φ θ) (up vx vy vφ vθ)) (- vy (* R (cos θ) vφ)))
(define L (L-wheel 'm 'R 'g 'α))
(define rolling
  (nonholonomic (lambda (t q v) (up ((rolling-x 'R) t q v) ((rolling-y 'R) t q v)))))
(define (rolling-velocity t q v)
  (define-values (θ vφ) (values (ref q 3) (ref v 2)))
  (up (* 'R (sin θ) vφ) (* 'R (cos θ) vφ) vφ (ref v 3)))
(define q (up 'x 'y 'φ 'θ))
(define state (up 't q (rolling-velocity 't q (up 'vx 'vy 'vφ 'vθ))))
(define solution ((constrained-accelerations L rolling) state))

(test-case "the wheel: φ̈ = −g sin α cos θ/2R, θ̈ = 0; the sign in circulation is refuted"
  (define inertia (* 2 'm (square 'R) (ref solution 0 2)))
  (define weight (* 'm 'g (sin 'α) 'R (cos 'θ)))
  (check-proved (verify-equal inertia (- weight)))
  (define wrong (verify-equal inertia weight))
  (check-refuted wrong)
  (check-true (pair? (verdict-witness wrong)))
  (check-identity (ref solution 0 3) 0))

(test-case "the wheel: its multipliers"
  (define φ-acceleration (ref solution 0 2))
  (define (rate-of wave slope) (* 'R (+ (* slope 'vθ 'vφ) (* wave φ-acceleration))))
  (check-identity (ref solution 1)
                  (up (* 'm (rate-of (sin 'θ) (cos 'θ)))
                      (+ (* 'm (rate-of (cos 'θ) (- (sin 'θ)))) (* 'm 'g (sin 'α))))))

(test-case "the wheel: a motion with its multipliers, proved; with the other sign, refuted"
  (define ((path sign) t)
    (define wt (* 'ω t))
    (define k (/ (* sign 'g (sin 'α)) 2))
    (up (* -1 (/ k 'ω) (- (/ t 2) (/ (sin (* 2 wt)) (* 4 'ω))))
        (* -1 (/ k (* 2 (square 'ω))) (square (sin wt)))
        (/ (* k (cos wt)) (* 'R (square 'ω)))
        wt))
  (define ((multipliers sign) t)
    (define a (((expt D 2) (path sign)) t))
    (up (* 'm (ref a 0)) (+ (* 'm (ref a 1)) (* 'm 'g (sin 'α)))))
  (define (verdict sign with?)
    (verify-solution L (path sign) #:constraints rolling
                     #:multipliers (and with? (multipliers sign))))
  (check-proved (verdict 1 #t))
  (check-proved (verdict 1 #f))
  (check-refuted (verdict -1 #t))
  (check-true (pair? (verdict-witness (verdict -1 #f)))))

;; ---------------------------------------------------------------------------
;; Substitution

(define wheel-state (up 't q (up 'vx 'vy 'vφ 'vθ)))

(test-case "the wheel: both constraints substituted in L fail, as they lose gravity in φ"
  (define r (reduce-by-substitution L rolling rolling-velocity wheel-state))
  (check-refuted (reduction-integrability r))
  (check-refuted (reduction-agreement r))
  ;; an equation for y that nothing can satisfy
  (check-identity (ref (verdict-residual (reduction-agreement r)) 1) (* 'm 'g (sin 'α)))
  (check-identity (((partial 1) r) wheel-state) (down 0 (* -1 'm 'g (sin 'α)) 0 0))
  (check-regexp-match #rx"nonholonomic; to substitute them is no valid step\n  its equations: wrong"
                      (format "~a" r)))

(test-case "the wheel: with the multiplier of ẏ kept, substitution happens to agree"
  (define r
    (reduce-by-substitution L rolling rolling-velocity wheel-state
                            #:keep (nonholonomic (rolling-y 'R))))
  (check-refuted (reduction-integrability r))
  (check-proved (reduction-agreement r))
  (check-regexp-match #rx"the motion satisfies them, as it happens for this system"
                      (format "~a" r)))

(test-case "the wheel: with both multipliers kept, nothing is lost"
  (define (as-given t q v) (rolling-velocity t q v))
  (check-proved (reduction-agreement
                 (reduce-by-substitution L rolling as-given wheel-state #:keep rolling))))

(define (L-edge (up t (up x y θ) (up vx vy ω)))
  (+ (* 1/2 'm (+ (square vx) (square vy))) (* 1/2 'J (square ω)) (* 'm 'g x (sin 'α))))
(define blade
  (nonholonomic (lambda (t q v) (- (* (ref v 0) (sin (ref q 2))) (* (ref v 1) (cos (ref q 2)))))))
(define (along-blade t q v) (up (ref v 0) (* (ref v 0) (tan (ref q 2))) (ref v 2)))
(define edge-state (up 't (up 'x 'y 'θ) (up 'v 'vy 'ω)))

(test-case "the knife edge: θ̈ = 0; substituted, J θ̈ = m ẋ² tan θ/cos² θ, which is refuted"
  (define on-blade (up 't (up 'x 'y 'θ) (along-blade 't (up 'x 'y 'θ) (up 'v 'vy 'ω))))
  (check-identity (ref ((constrained-accelerations L-edge blade) on-blade) 0 2) 0)
  (define r (reduce-by-substitution L-edge blade along-blade edge-state))
  (define equation (ref ((Euler-Lagrange-operator r)
                         (up 't (up 'x 'y 'θ) (up 'v 'vy 'ω) (up 'ax 'ay 'aθ)))
                        2))
  (check-identity equation (- (* 'J 'aθ) (/ (* 'm (square 'v) (tan 'θ)) (square (cos 'θ)))))
  (check-refuted (reduction-integrability r))
  (check-refuted (reduction-agreement r))
  (check-true (pair? (verdict-witness (reduction-agreement r)))))

(test-case "where the constraint is integrable and nothing else depends on it, all is well"
  (define (L (up t (up x θ) (up v ω))) (+ (* 1/2 'm (square v)) (* 1/2 'J (square ω)) (* 'F θ)))
  (define r
    (reduce-by-substitution L (nonholonomic (lambda (t q v) (- (ref v 0) (* 'R (ref v 1)))))
                            (lambda (t q v) (up (* 'R (ref v 1)) (ref v 1)))
                            (up 't (up 'x 'θ) (up 'v 'ω))))
  (check-proved (reduction-integrability r))
  (check-proved (reduction-agreement r)))

(test-case "velocities that do not keep the constraints are no substitution"
  (check-exn #rx"^reduce-by-substitution: the velocities do not keep the constraints\n"
             (lambda ()
               (reduce-by-substitution L-edge blade (lambda (t q v) v) edge-state)))
  (check-exn #rx"^reduce-by-substitution: expected a function"
             (lambda () (reduce-by-substitution L-edge blade 'v edge-state))))
