#lang mechanics
;; Exercise 3.15 (SICM 3.11): surfaces of section of spin and orbit
;; Checked: its Hamiltonian, islands and their widths, fixed points and chaos as ε grows
;; How: a strobe map at the passage of the pericentre; against pendulums and forced librations

;; With the true anomaly f as clock, for time cannot be had in closed form: C = 1, n = 1, and
;; 1/r³ = (1 + e cos f)³/(1 − e²)³, df/dt = (1 + e cos f)²/(1 − e²)^(3/2).
;; State (up f θ p): θ' = p/f', p' = −(ε²/2) sin 2(θ − f)/r³ / f'.
(define (rate-and-cube e f)
  (define reach (+ 1 (* e (cos f))))
  (values (/ (square reach) (expt (- 1 (square e)) 3/2))
          (expt (/ reach (- 1 (square e))) 3)))
(define ((spin epsilon e) (up f theta p))
  (define-values (rate cubed) (rate-and-cube e f))
  (up 1
      (/ p rate)
      (/ (* -1/2 (square epsilon) cubed (sin (* 2 (- theta f)))) rate)))

;; (a) With f for the time the Hamiltonian is that of the time, over f'.
(define ((H epsilon e) (up f theta p))
  (define-values (rate cubed) (rate-and-cube e f))
  (/ (- (* 1/2 (square p)) (* 1/4 (square epsilon) cubed (cos (* 2 (- theta f))))) rate))
(define formulation
  (verify-equal ((Hamiltonian->state-derivative (H 'epsilon 'e)) (up 'f 'theta 'p))
                ((spin 'epsilon 'e) (up 'f 'theta 'p))))
formulation

;; One orbit later, at the pericentre.  The body looks the same after half a turn.
(define (fold x) (- x (* :pi (round (/ x :pi)))))
(define (strobe epsilon e)
  (define orbit-later (stroboscopic-map (spin epsilon e) :2pi #:tolerance 1e-11))
  (lambda (theta p return fail)
    (define next (orbit-later (up 0 theta p)))
    (return (fold (- (coordinate next) :2pi)) (momentum next))))

;; The parameters of the exercise.  Half a turn before pericentre is where 1:2 is stable.
;; (b)
(define resonances (list (up 0. 1.) (up 0. 1.5) (up (/ :pi 2) 0.5)))
(define (middle guess [epsilon 0.1])
  (define T (strobe epsilon 0.1))
  (define (about x y return fail)
    (T (+ x (ref guess 0)) y (lambda (x y) (return (fold (- x (ref guess 0))) y)) fail))
  (define point (find-fixed-point about (up 0.01 (ref guess 1))))
  (list about point))
(define middles (map middle resonances))
(map (lambda (m) (fixed-point-kind (cadr m))) middles)

;; How far up and down from the middle the angle still swings, for 70 orbits.
(define (swings? about p)
  (let loop ([k 0] [x 0.] [p p])
    (or (= k 70)
        (about x p (lambda (x2 p2) (and (< (abs (- x2 x)) 1.2) (loop (+ k 1) x2 p2))) void))))
(define (edge about p step)
  (for/fold ([inside p] [step step] #:result inside) ([k 9])
    (if (swings? about (+ inside step)) (values (+ inside step) step) (values inside (/ step 2)))))
(define (width m)
  (define p (ref (fixed-point-coordinates (cadr m)) 1))
  (- (edge (car m) p 0.03) (edge (car m) p -0.03)))
(define widths (map width middles))
widths

;; An attempt: near each the angle from the resonance is a pendulum's with the frequency ε √H, where
;; H = 1 − 5e²/2, 7e/2 and e/2, so the width is 2 ε √H.  A slip takes all for as wide as the first.
(define attempt (map (lambda (H) (* 2 0.1 (sqrt H))) '(0.975 0.35 0.05)))
(define (near? a b) (< (abs (- a b)) (* 0.2 b)))
attempt

;; (c) From beside the unstable point of 1:1, a quarter of a turn off, the greatest p of an orbit:
;; the chaotic zones have merged where it comes to 3:2.  Overlap of the half-widths,
;; ε (1 + √(7e/2)) = 1/2, says 0.31.
(define (highest epsilon)
  (define T (strobe epsilon 0.1))
  (for/fold ([theta 1.57] [p 1.001] [most 0.] #:result most) ([k 2000])
    (T theta p (lambda (theta p) (values theta p (max most p))) void)))
(define reached (map highest '(0.2 0.24 0.3 0.32)))
reached

;; (d) Where 1:1 is stable and where not: f swings by 2e about the mean anomaly, with the frequency
;; 1, and drives the angle, of which the own frequency squared is ±ε²: p = 1 ∓ 2eε²/(1 ∓ ε²).
(define (momenta-1:1 epsilon)
  (for/list ([theta (list 0. (/ :pi 2))])
    (ref (fixed-point-coordinates (cadr (middle (up theta 1.) epsilon))) 1)))
(define (librations epsilon)
  (define swing (* 2 0.1 (square epsilon)))
  (list (- 1 (/ swing (- 1 (square epsilon)))) (+ 1 (/ swing (+ 1 (square epsilon))))))
(momenta-1:1 0.2)
(librations 0.2)

;; At ε = 0.89, as of Hyperion, all is chaos around the synchronous state.
(define growth (maximal-Lyapunov-exponent (strobe 0.89 0.1) (up 1. 1.05) 150))
(define exponent (car (Lyapunov-values growth)))
(> exponent 0.2)

(module+ test
  (require rackunit)
  (test-case "the middles are stable, and areas are kept"
    (for ([m middles])
      (check-equal? (fixed-point-kind (cadr m)) 'elliptic)
      (check-= (fixed-point-determinant (cadr m)) 1 1e-8)))
  (test-case "the widths of the islands"
    (for ([found widths] [expected attempt]) (check-true (near? found expected)))
    (check-false (near? (list-ref widths 2) (car attempt))))
  (test-case "the Hamiltonian formulation"
    (check-pred proved? formulation))
  (test-case "the zones of 1:1 and 3:2 merge between 0.24 and 0.30"
    (check-true (< (cadr reached) 1.4))
    (check-true (> (caddr reached) 1.5)))
  (test-case "the points of 1:1 part as librations do"
    (for* ([epsilon '(0.05 0.1 0.2 0.3 0.4)])
      (for ([p (momenta-1:1 epsilon)] [q (librations epsilon)])
        (check-= (/ (- p 1) (- q 1)) 1 0.15))))
  (test-case "Hyperion tumbles"
    (check-true (> exponent 0.2))))
