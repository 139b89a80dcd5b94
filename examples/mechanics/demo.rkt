#lang mechanics
;; A tour of the main job: Lagrange's equations along literal and proposed
;; paths, each with its verdict and the time it took.

(define-syntax-rule (title text) (printf "\n── ~a\n\n" text))

;; What the reader would type at the prompt.
(define (print-input form)
  (parameterize ([print-reader-abbreviations #t])
    (printf "> ~s\n" form)))

;; Prints an expression as one would type it, what the prompt answers, and the
;; time that took.
(define-syntax-rule (step expression)
  (let ([start (current-inexact-milliseconds)])
    (print-input 'expression)
    (print-expression expression)
    (let ([elapsed (- (current-inexact-milliseconds) start)])
      (printf "  ; ~a ms\n\n" (/ (round (* 100 elapsed)) 100)))))

(define x (literal-function 'x))
(define y (literal-function 'y))
(define r (literal-function 'r))
(define phi (literal-function 'phi))

;; ---------------------------------------------------------------------------
(title "A free particle: the equation of motion, and a path that solves it")

(define ((L-free m) (up t q v))
  (* 1/2 m (square v)))

(step (((Lagrange-equations (L-free 'm)) x) 't))
(step (verify-solution (L-free 'm)
                       (lambda (t) (up (+ (* 'a t) 'a0) (+ (* 'b t) 'b0)))))

;; ---------------------------------------------------------------------------
(title "A harmonic oscillator: is a cos(ωt + φ) a solution?")

(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))

(define (proposed t) (* 'a (cos (+ (* 'omega t) 'phi))))

(step (((Lagrange-equations (L-harmonic 'm 'k)) x) 't))
(step (((Lagrange-equations (L-harmonic 'm 'k)) proposed) 't))
(step (verify-solution (L-harmonic 'm 'k) proposed))
(step (verify-solution (L-harmonic 'm (* 'm (square 'omega))) proposed))

;; ---------------------------------------------------------------------------
(title "The Kepler problem, in rectangular and in polar coordinates")

(define ((L-Kepler m mu) (up t (up x y) (up vx vy)))
  (+ (* 1/2 m (+ (square vx) (square vy)))
     (/ mu (sqrt (+ (square x) (square y))))))

(define (circular-orbit t)
  (up (* 'R (cos (* 'omega t))) (* 'R (sin (* 'omega t)))))

(step (((Lagrange-equations (L-Kepler 'm 'mu)) (up x y)) 't))
(step (((Lagrange-equations (compose (L-Kepler 'm 'mu) (F->C p->r))) (up r phi)) 't))
(step (verify-solution (L-Kepler 'm 'mu) circular-orbit))
(step (verify-solution (L-Kepler 'm (* 'm (square 'omega) (cube 'R))) circular-orbit))

;; ---------------------------------------------------------------------------
(title "A double pendulum, pulled back from rectangular coordinates")

(define ((L-rectangular m1 m2 g) (up t (up (up x1 y1) (up x2 y2)) (up v1 v2)))
  (- (+ (* 1/2 m1 (square v1)) (* 1/2 m2 (square v2)))
     (+ (* m1 g y1) (* m2 g y2))))

(define ((double-pendulum l1 l2) (up t (up theta1 theta2) v))
  (let ([x1 (* l1 (sin theta1))] [y1 (- (* l1 (cos theta1)))])
    (up (up x1 y1)
        (up (+ x1 (* l2 (sin theta2))) (- y1 (* l2 (cos theta2)))))))

(define L-double-pendulum
  (compose (L-rectangular 'm1 'm2 'g) (F->C (double-pendulum 'l1 'l2))))

(step (((Lagrange-equations L-double-pendulum)
        (up (literal-function 'theta1) (literal-function 'theta2)))
       't))
(step (verify-solution L-double-pendulum (lambda (t) (up 0 0))))
(step (verify-solution L-double-pendulum (lambda (t) (up 0 (* 'Omega t)))))

;; ---------------------------------------------------------------------------
(printf "\nNext:  make repl   a prompt with all of this at hand
       make test   the tests
       make docs   the manual, in build/doc (sources in scribblings/mechanics)\n")
