#lang mechanics
;; Exercise 5.10 (SICM 5.3): areas around the origin
;; Checked: that a symplectic transformation may change a loop integral
;; How: a verdict, and both integrals of a loop about the origin, and of one that is not

;; x = √(2 (J + a)) sin θ and p = √(2 (J + a)) cos θ.

(define state (up 't 'theta 'J))
(define ((shifted a) state)
  (define r (sqrt (* 2 (+ (momentum state) a))))
  (up (time state) (* r (sin (coordinate state))) (* r (cos (coordinate state)))))

(define right (verify-symplectic (shifted 'a) state))
right

;; Once around at constant J: J dθ gives 2π J, and p dx gives 2π (J + a). In θ and J the curve
;; bounds no region: the circle x² + p² < 2a about the origin has no image.
(define (around angle) (up 0 angle 1.5))
(define before (loop-integral around 0 (* 2 pi)))
(define after (loop-integral (compose (shifted 0.25) around) 0 (* 2 pi)))
(/ (- after before) (* 2 pi))

;; A closed curve in θ and J bounds one, and keeps its area.
(define (elsewhere x) (up 0 (+ 1 (* 0.3 (cos x))) (+ 1.5 (* 0.4 (sin x)))))
(define kept
  (- (loop-integral (compose (shifted 0.25) elsewhere) 0 (* 2 pi))
     (loop-integral elsewhere 0 (* 2 pi))))

;; The slip: that "symplectic" keeps the first one, too.
(define slip (- after before))

(module+ test
  (require rackunit)
  (test-case "symplectic for any a, and areas within the plane of θ and J are kept"
    (check-pred proved? right)
    (check-= kept 0 1e-9))
  (test-case "around the origin 2π a is gained"
    (check-= slip (* 2 pi 0.25) 1e-9)))
