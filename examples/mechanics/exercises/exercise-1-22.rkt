#lang mechanics
;; Exercise 1.22 (SICM 1.6.2): the rod of a driven pendulum
;; Checked: Newton's equations with the tension; the angle's equation; the tension
;; How: against the Lagrangian with a constraint, and with the angle as coordinate

;; The pivot of a pendulum moves up and down, y_s(t).  Show that the constraint's Lagrangian
;; has Newton's equations, and find the tension of the rod.

(define y_s (literal-function 'y_s))

(define ((L-falling m g) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (* m g y)))

;; In rectangular coordinates, the tension F being the multiplier.
(define ((L-rod m l g) (up t (up x y F) (up vx vy Fdot)))
  (- ((L-falling m g) (up t (up x y) (up vx vy)))
     (* F (- (sqrt (+ (square x) (square (- y (y_s t))))) l))))
(define L (L-rod 'm 'l 'g))

(define x (literal-function 'x))
(define y (literal-function 'y))
(define F (literal-function 'F))
(define distance (sqrt (+ (square x) (square (- y y_s)))))
(define Newton
  (down (+ (* 'm ((expt D 2) x)) (* F (/ x distance)))
        (+ (* 'm ((expt D 2) y)) (* 'm 'g) (* F (/ (- y y_s) distance)))
        (- distance 'l)))
(define equations (verify-equal ((Lagrange-equations L) (up x y F)) Newton))
equations

;; With angle, distance and tension as coordinates.
(define (from-angle local)
  (match (coordinate local)
    [(up theta c F) (up (* c (sin theta)) (- (y_s (time local)) (* c (cos theta))) F)]))
(define theta (literal-function 'theta))
(define angle-and-tension
  (lambda (tension)
    (((Lagrange-equations (compose L (F->C from-angle))) (up theta (lambda (t) 'l) tension)) 't)))

;; The tension holds the bob up and turns it; by a slip the pivot's acceleration is left out.
(define (tension pivot)
  (* 'm (+ (* 'l (square (D theta)))
           (* (+ 'g (* pivot ((expt D 2) y_s))) (compose cos theta)))))
(define right (prove-zero (ref (angle-and-tension (tension 1)) 1)))
(define wrong (prove-zero (ref (angle-and-tension (tension 0)) 1)))
right
wrong

;; The equation of the angle is that of L-pend, where no tension occurs.
(require mechanics/book)
(define angle
  (verify-equal (ref (angle-and-tension (tension 1)) 0)
                (((Lagrange-equations (L-pend 'm 'l 'g y_s)) theta) 't)))
angle

(module+ test
  (require rackunit)
  (test-case "Newton's equations"
    (check-pred proved? equations))
  (test-case "the tension knows of the pivot's acceleration"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-equal? (expression (verdict-residual wrong))
                  '(* -1 m (cos (theta t)) (((expt D 2) y_s) t))))
  (test-case "both Lagrangians say the same of the angle"
    (check-pred proved? angle)))
