#lang mechanics
;; Exercise 2.4 (SICM 2.3): Jupiter
;; Checked: the moment of inertia of a planet that is denser inside
;; How: against integrals of the density, and by a comparison

;; The density of a planet like Jupiter is about ρ(r) = (M/R³) sin(π r/R)/(4 r/R).  Is M its mass,
;; and what is its moment of inertia, in units of M R²?

(define (density r) (if (= r 0) (/ :pi 4.) (/ (sin (* :pi r)) (* 4 r))))

;; Shells: mass 4 π ρ r² dr, moment two thirds of that times r².
(define (shell-mass r) (* 4 :pi (density r) (square r)))
(define mass (definite-integral shell-mass 0 1.))
(define moment (definite-integral (lambda (r) (* 2/3 (square r) (shell-mass r))) 0 1.))
(list mass moment)

;; An attempt by hand: ∫ r³ sin π r dr = (1 − 6/π²)/π.
(define attempt (* 2/3 (- 1 (/ 6 (square :pi)))))
(define right (abs (- moment attempt)))
(< right 1e-10)

;; A slip: the formula for homogeneous shells integrated without the 2/3.
(define slip (- 1 (/ 6 (square :pi))))
(/ slip moment)

;; By parts, exactly: the antiderivative of r³ sin π r.
(define (F r)
  (let ((a 'pi))
    (+ (* (cos (* a r)) (- (/ (* 6 r) (cube a)) (/ (cube r) a)))
       (* (sin (* a r)) (- (/ (* 3 (square r)) (square a)) (/ 6 (expt a 4)))))))
(define by-parts (verify-equal ((D F) 'r) (* (cube 'r) (sin (* 'pi 'r)))))
by-parts

;; Any planet that is denser inside has less than a homogeneous one.
(< moment 2/5)

(module+ test
  (require rackunit)
  (test-case "mass and moment"
    (check-= mass 1 1e-10)
    (check-= moment attempt 1e-10)
    (check-= attempt 0.26138 1e-5)
    (check-pred proved? by-parts))
  (test-case "less than that of a homogeneous ball"
    (check-true (< moment 2/5)))
  (test-case "the slip is wrong by the factor of a shell"
    (check-= (/ slip moment) 3/2 1e-9)))
