#lang mechanics
;; Exercise 1.21 (SICM 1.6.2): a dumbbell
;; Checked: the equations with the tension of the rod, and the tension
;; How: Newton's equations against the residual; then in centre of mass, distance and angle

;; Two masses are joined by a rod of length l in the plane; no other force acts on them.
;; The rod pulls with a tension F.  Derive the equations of motion, and find F.

;; The tension is a coordinate here, whose equation keeps the distance.
(define ((L-dumbbell m_0 m_1 l) (up t (up x_0 y_0 x_1 y_1 F) (up vx_0 vy_0 vx_1 vy_1 Fdot)))
  (define distance (sqrt (+ (square (- x_1 x_0)) (square (- y_1 y_0)))))
  (- (+ (* 1/2 m_0 (+ (square vx_0) (square vy_0)))
        (* 1/2 m_1 (+ (square vx_1) (square vy_1))))
     (* F (- distance l))))
(define L (L-dumbbell 'm_0 'm_1 'l))

;; Newton's equations.  By a slip the rod pulls both masses the same way.
(define-values (x_0 y_0 x_1 y_1 F)
  (apply values (map literal-function '(x_0 y_0 x_1 y_1 F))))
(define (Newton sign)
  (define distance (sqrt (+ (square (- x_1 x_0)) (square (- y_1 y_0)))))
  (define pull-x (* F (/ (- x_1 x_0) distance)))
  (define pull-y (* F (/ (- y_1 y_0) distance)))
  (down (- (* 'm_0 ((expt D 2) x_0)) pull-x)
        (- (* 'm_0 ((expt D 2) y_0)) pull-y)
        (- (* 'm_1 ((expt D 2) x_1)) (* sign pull-x))
        (- (* 'm_1 ((expt D 2) y_1)) (* sign pull-y))
        (- distance 'l)))

(define residual (((Lagrange-equations L) (up x_0 y_0 x_1 y_1 F)) 't))
(define right (verify-equal residual ((Newton -1) 't)))
(define wrong (verify-equal residual ((Newton 1) 't)))
right
(verdict-status wrong)

;; Its residual is zero but for the second mass.
(for/list ([r (verdict-residual wrong)]) (verdict-status (prove-zero r)))

;; With the centre of mass, the distance c and the angle θ as coordinates:
(define ((from-centre m_0 m_1) (up t (up x y theta c F) v))
  (define (along r) (up (+ x (* r (cos theta))) (+ y (* r (sin theta)))))
  (define M (+ m_0 m_1))
  (define end_0 (along (- (/ (* m_1 c) M))))
  (define end_1 (along (/ (* m_0 c) M)))
  (up (ref end_0 0) (ref end_0 1) (ref end_1 0) (ref end_1 1) F))
(define L-centre (compose L (F->C (from-centre 'm_0 'm_1))))

;; A dumbbell that flies and turns uniformly, with an attempt at the tension.
(define ((flight tension) t)
  (up (* 'u t) (* 'w t) (* 'omega t) 'l tension))
(define reduced-mass (/ (* 'm_0 'm_1) (+ 'm_0 'm_1)))
(define tension (verify-solution L-centre (flight (* reduced-mass 'l (square 'omega)))))
(define no-tension (verify-solution L-centre (flight (* 'm_0 'l (square 'omega)))))
tension
no-tension

(module+ test
  (require rackunit)
  (test-case "the Lagrangian has Newton's equations"
    (check-pred proved? right)
    (check-equal? (for/list ([r (verdict-residual wrong)]) (verdict-status (prove-zero r)))
                  '(proved proved refuted refuted proved)))
  (test-case "the tension is the reduced mass's centripetal force"
    (check-pred proved? tension)
    (check-pred refuted? no-tension)))
