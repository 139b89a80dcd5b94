#lang mechanics
;; A ball rolls on a turntable
;;
;; The table turns at the angular velocity Ω about the z axis; a homogeneous ball of mass m
;; and radius R rolls on it.  The coordinates are those of its centre and Euler's angles.
;; Where it touches the table, the ball has the velocity of the table.

(require mechanics/plot)
(provide picture)

(define (spin (up t (up x y φ θ ψ) (up vx vy vφ vθ vψ)))
  (up (+ (* vθ (cos φ)) (* vψ (sin θ) (sin φ)))
      (- (* vθ (sin φ)) (* vψ (sin θ) (cos φ)))
      (+ vφ (* vψ (cos θ)))))
(define ((L-ball m R) (up t (up x y φ θ ψ) (up vx vy vφ vθ vψ)))
  (+ (* 1/2 m (+ (square vx) (square vy)))
     (* 1/5 m (square R)
        (square (spin (up t (up x y φ θ ψ) (up vx vy vφ vθ vψ)))))))

(define ((slip R Ω) t q v)
  (let ([ω (spin (up t q v))])
    (up (- (+ (ref v 0) (* Ω (ref q 1))) (* R (ref ω 1)))
        (+ (- (ref v 1) (* Ω (ref q 0))) (* R (ref ω 0))))))
(define (rolling R Ω) (nonholonomic (slip R Ω)))

;; A state of rolling: the velocity of the centre follows from the spin.
(define (rolls R Ω q rates)
  (let* ([v (up 0 0 (ref rates 0) (ref rates 1) (ref rates 2))]
         [too-much ((slip R Ω) 0 q v)])
    (up (* -1 (ref too-much 0)) (* -1 (ref too-much 1))
        (ref rates 0) (ref rates 1) (ref rates 2))))

(define q (up 'x 'y 'φ 'θ 'ψ))
(define v (rolls 'R 'Ω q (up 'φdot 'θdot 'ψdot)))
(define accelerations
  (ref ((constrained-accelerations (L-ball 'm 'R) (rolling 'R 'Ω)) (up 't q v)) 0))

;; Whatever it does, its velocity turns, at two sevenths of the rate of the table.
(define (acceleration-at rate) (* rate (up (* -1 (ref v 1)) (ref v 0))))
(define acceleration (up (ref accelerations 0) (ref accelerations 1)))
(verify-equal acceleration (acceleration-at (* 2/7 'Ω)))

;; Not at that of the table.
(verify-equal acceleration (acceleration-at 'Ω))

;; Hence it runs round a circle, of any size and anywhere, and never flies off.
(define (circle t)
  (up (+ 'a (* 'r (cos (* 2/7 'Ω t)))) (+ 'b (* 'r (sin (* 2/7 'Ω t))))))
(define (turned u) (up (* -1 (ref u 1)) (ref u 0)))
(verify-equal (((expt D 2) circle) 't) (* 2/7 'Ω (turned ((D circle) 't))))

;; In numbers, with Ω and m equal to 1: three balls, while the table turns 7/2 times.
(define start (up 0.5 0. 0. 1.5 0.))
(define roll
  (let ([derivative (constrained-state-derivative (L-ball 1. 0.1) (rolling 0.1 1.))])
    (lambda (rates)
      (evolve-trajectory derivative (up 0. start (rolls 0.1 1. start rates))
                         (* 7/2 :2pi) #:tolerance 1e-10))))
(define balls (map roll (list (up 0. 1. 2.) (up 0. 0. 5.) (up 0. 10. 2.))))

;; The first one also as it is seen from the table.
(define (seen-from-table state)
  (let ([q (coordinate state)] [t (time state)])
    (up (+ (* (cos t) (ref q 0)) (* (sin t) (ref q 1)))
        (- (* (cos t) (ref q 1)) (* (sin t) (ref q 0))))))

(define picture
  (frame -4.5 4.5 -4.5 4.5 #:aspect-ratio 'equal #:x-label "x" #:y-label "y"))
(define (part k) (lambda (state) (ref (coordinate state) k)))
(for ([ball balls]) (plot-trajectory picture ball (part 0) (part 1)))
(plot-parametric picture (compose seen-from-table (car balls)) 0. (* 7/2 :2pi)
                 #:color 'red #:label "seen from the table")
picture

(module+ main
  (require "../figures/save.rkt")
  (save-figure picture "turntable.png"))

(module+ test
  (require rackunit)
  (define-syntax-rule (check-status status verdict)
    (check-eq? (verdict-status verdict) status))
  (test-case "the velocity turns at two sevenths of the table's rate"
    (check-status 'proved (verify-equal acceleration (acceleration-at (* 2/7 'Ω))))
    (check-status 'refuted (verify-equal acceleration (acceleration-at 'Ω)))
    (check-status 'refuted (verify-equal acceleration (acceleration-at (* -2/7 'Ω)))))
  (test-case "a state of rolling does not slip"
    (check-status 'proved (prove-zero ((slip 'R 'Ω) 't q v))))
  (test-case "on a table at rest it runs straight on"
    (check-status 'proved (prove-zero (substitute acceleration 'Ω 0))))
  (test-case "the numbers are the circle, passed once"
    (for ([ball balls])
      (define-values (r0 v0) (values (up 0.5 0.) (velocity (ball 0.))))
      (define arm (* 7/2 (up (ref v0 1) (* -1 (ref v0 0)))))
      (for ([t (list 1. 5. 12. (* 7/2 :2pi))])
        (define angle (* 2/7 t))
        (define there
          (+ (- r0 arm)
             (+ (* (cos angle) arm) (* (sin angle) (turned arm)))))
        (check-= (ref (coordinate (ball t)) 0) (ref there 0) 1e-8)
        (check-= (ref (coordinate (ball t)) 1) (ref there 1) 1e-8)))))
