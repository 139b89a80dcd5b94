#lang mechanics
;; A free particle seen from elsewhere (SICM exercise 1.29): which changes of coordinates
;; keep its equations?

(define (L-free (up t q v)) (* 1/2 'm (square v)))
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))

(define (compare-seen-from transformation)
  (compare-Lagrangians L-free (compose L-free (F->C transformation)) plane))

;; Shifted in space, and turned: the Lagrangian itself is the same.
(define (elsewhere (up t (up x y) v))
  (up (+ (* (cos 'alpha) x) (* -1 (sin 'alpha) y) 'a)
      (+ (* (sin 'alpha) x) (* (cos 'alpha) y) 'b)))
(compare-seen-from elsewhere)

;; Moving with a constant velocity: the same but for a total time derivative.
(define (moving (up t (up x y) v)) (up (+ x (* 'V t)) y))
(compare-seen-from moving)

;; A plausible attempt to leave it at the term that is linear in the velocity.
(define (attempt local) (* 'm 'V (ref (coordinate local) 0)))
(define difference (- (compose L-free (F->C moving)) L-free))
(verify-equal (difference plane) ((Dt attempt) plane))

;; Turning, and speeding up: other equations.  Their residuals are the fictitious forces.
(define (turning (up t (up x y) v))
  (define-values (c s) (values (cos (* 'Omega t)) (sin (* 'Omega t))))
  (up (- (* c x) (* s y)) (+ (* s x) (* c y))))
(compare-seen-from turning)
(define (falling (up t (up x y) v)) (up x (+ y (* 1/2 'g (square t)))))
(compare-seen-from falling)

(module+ test
  (require rackunit)
  (test-case "what keeps the equations"
    (check-equal? (map (lambda (F) (equivalence-kind (compare-seen-from F)))
                       (list elsewhere moving turning falling))
                  '(total-derivative total-derivative #f #f)))
  (test-case "the gauge function of a moving frame has a term in the time as well"
    (check-equal? (expression (equivalence-gauge (compare-seen-from moving)))
                  '(+ (* 1/2 (expt V 2) m t) (* V m x)))
    (check-pred refuted? (verify-equal (difference plane) ((Dt attempt) plane)))))
