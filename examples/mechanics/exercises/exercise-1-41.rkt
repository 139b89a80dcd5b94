#lang mechanics
;; Exercise 1.41 (SICM 1.10.1): a golf ball on a hilly green
;; Checked: the equations in x and y, with the height as a constraint
;; How: equations without multipliers against those by hand; an approximation judged

;; A ball slides without friction on a green of height h(x, y).  Derive the equations for x and y.
;; When will the potential energy m g h(x, y), with the ball moving in the plane, do?

(define h (literal-function 'h (-> (UP Real Real) Real)))

(define ((L-falling m g) (up t (up x y z) v))
  (- (* 1/2 m (square v)) (* m g z)))
(define green (holonomic (lambda (t (up x y z)) (- z (h (up x y))))))
(define (on-the-green local)
  (match (coordinate local) [(up x y) (up x y (h (up x y)))]))

(define plane (up (literal-function 'x) (literal-function 'y)))
(define equations
  (ref (((eliminate-multipliers (L-falling 'm 'g) green on-the-green) plane) 't) 0))

;; The ball presses as its weight and the rise of the ground demand.
(define slope (compose (D h) plane))
(define rise ((expt D 2) (compose h plane)))
(define (by-hand vertical-force)
  ((down (+ (* 'm ((expt D 2) (ref plane 0))) (* vertical-force (ref slope 0)))
         (+ (* 'm ((expt D 2) (ref plane 1))) (* vertical-force (ref slope 1))))
   't))
(define right (verify-equal equations (by-hand (* 'm (+ 'g rise)))))
(define flat (verify-equal equations (by-hand (* 'm 'g))))
right
(verdict-status flat)

;; The rest of the approximation is of second order in the height: it will do for
;; slopes that are small.
(define left-over
  (verify-equal (verdict-residual flat) (* 'm (rise 't) (slope 't))))
left-over

(module+ test
  (require rackunit)
  (test-case "the equations with the rise of the ground"
    (check-pred proved? right))
  (test-case "the approximation lacks a product of slope and rise"
    (check-pred refuted? flat)
    (check-pred proved? left-over)))
