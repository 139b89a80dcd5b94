#lang mechanics
;; Exercise 1.29 (SICM 1.6.4): Galilean invariance
;; Checked: that axes in uniform motion change the Lagrangian by a total time derivative
;; How: Lagrangians compared; the function that I found differentiated

;; A free particle is seen from axes that are shifted by a and move at the constant velocity u:
;; x = x' + a + u t.  Show that its Lagrangian changes by a total time derivative, and of what.

(define ((L-free m) (up t x v)) (* 1/2 m (square v)))
(define ((moving a u) local) (+ (coordinate local) a (* u (time local))))
(define L (L-free 'm))
(define L-moving (compose L (F->C (moving 'a 'u))))

(define line (up 't 'x 'v))
(define comparison (compare-Lagrangians L L-moving line))
comparison

;; An attempt at the function, and one that forgets the energy of the motion of the axes: a
;; constant, which changes no equation, but is a derivative too.
(define (attempt (up t x)) (* 'm (+ (* 'u x) (* 1/2 (square 'u) t))))
(define (slip (up t x)) (* 'm 'u x))
(define change (- (L-moving line) (L line)))
(define right (verify-equal change ((Dt attempt) line)))
(define wrong (verify-equal change ((Dt slip) line)))
right
wrong

;; Axes that are accelerated are something else: what is left over is their force.
(define (accelerated local) (+ (coordinate local) (* 1/2 'A (square (time local)))))
(define fall (compare-Lagrangians L (compose L (F->C accelerated)) line))
fall

;; In a plane, axes that are turned and shifted leave the Lagrangian what it is; axes that
;; turn give other equations, with the fictitious forces in them.
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))
(define (seen-from F) (compare-Lagrangians L (compose L (F->C F)) plane))
(define (elsewhere local) (+ ((turned-by 'alpha) (coordinate local)) (up 'a 'b)))
(define (turning local) ((turned-by (* 'Omega (time local))) (coordinate local)))
(define ((turned-by angle) (up x y))
  (up (- (* (cos angle) x) (* (sin angle) y)) (+ (* (sin angle) x) (* (cos angle) y))))
(define turned (seen-from elsewhere))
(define rotation (seen-from turning))
turned
rotation

(module+ test
  (require rackunit)
  (test-case "a total time derivative apart, of what I found"
    (check-eq? (equivalence-kind comparison) 'total-derivative)
    (check-pred proved? right)
    (check-pred proved? (verify-equal (equivalence-gauge comparison) (attempt (up 't 'x)))))
  (test-case "a constant is missing in the slip"
    (check-pred refuted? wrong)
    (check-equal? (expression (verdict-residual wrong)) '(* 1/2 m (expt u 2))))
  (test-case "acceleration is felt"
    (check-pred refuted? (equivalence-verdict fall)))
  (test-case "turned axes are as good, turning ones are not"
    (check-eq? (equivalence-kind turned) 'total-derivative)
    (check-false (equivalence-kind rotation))))
