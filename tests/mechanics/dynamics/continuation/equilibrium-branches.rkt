#lang racket/base
;; Equilibria followed as a parameter changes, against formulas.

(require mechanics mechanics/plot
         "../../support/checks.rkt" "../../support/close.rkt" "../../support/messages.rkt")

(define (kinds b) (map special-point-kind (branch-special-points b)))
(define (places b) (map special-point-parameter (branch-special-points b)))
(define (final xs) (car (reverse xs)))

;; A bead on a ring of radius 1 that turns about its vertical diameter
(define ((L-bead Omega) local)
  (define theta (coordinate local))
  (+ (* 1/2 (square (velocity local)))
     (* 1/2 (square Omega) (square (sin theta)))
     (* 9.8 (cos theta))))
(define (bead Omega) (Lagrangian->state-derivative (L-bead Omega)))
(define below (continue-equilibrium bead (up 0 0.1 0) 1 5))

(test-case "a bead on a turning ring: a pitchfork where the square of the rate is g/R"
  (check-equal? (kinds below) '(pitchfork))
  (check-close (places below) (list (sqrt 9.8)) 1e-12)
  (check-equal? (list (car (branch-stabilities below)) (final (branch-stabilities below))) '(#t #f))
  (check-close (final (branch-parameters below)) 5 1e-12)
  (check-eq? (branch-end below) 'range))

(test-case "the two branches that leave it, where cos(theta) is g/(R Omega^2)"
  (define pitchfork (car (branch-special-points below)))
  (define angles
    (for/list ([side '(1 -1)])
      (define b (switch-branch below pitchfork #:direction side))
      (check-true (final (branch-stabilities b)))
      (for ([Omega (branch-parameters b)] [state (branch-states b)])
        (check-close (* (square Omega) (cos (ref state 1))) 9.8 1e-8))
      (ref (final (branch-states b)) 1)))
  (check-close (sort angles <) (list (- (acos (/ 9.8 25))) (acos (/ 9.8 25))) 1e-10))

(define ((Lorenz rho) s)
  (define-values (x y z) (values (ref s 0) (ref s 1) (ref s 2)))
  (up (* 10 (- y x)) (- (* x (- rho z)) y) (- (* x y) (* 8/3 z))))

(test-case "Lorenz: a pitchfork at 1, and Hopf's point at 470/19"
  (define origin (continue-equilibrium Lorenz (up 0 0 0) 0 30))
  (check-equal? (kinds origin) '(pitchfork))
  (check-close (places origin) '(1) 1e-10)
  (define side (switch-branch origin (car (branch-special-points origin))))
  (check-equal? (kinds side) '(Hopf))
  (check-close (places side) (list 470/19) 1e-8)
  ;; there the frequency is the root of 8/3 (10 + rho)
  (define growing (car (branch-special-points side)))
  (check-close (apply max (map imag-part (special-point-spectrum growing)))
               (sqrt (* 8/3 (+ 10 470/19))) 1e-6)
  ;; the orbits that begin there are on the side of the stable equilibrium, and unstable
  (define orbits (switch-branch side growing #:most-steps 10))
  (check-true (< 23 (final (branch-parameters orbits)) 470/19))
  (check-false (final (branch-stabilities orbits))))

;; r' = p r − r³, θ' = 1
(define ((turning p) s)
  (define-values (x y) (values (ref s 0) (ref s 1)))
  (define r^2 (+ (square x) (square y)))
  (up (- (* (- p r^2) x) y) (+ x (* (- p r^2) y))))

(test-case "the orbits that begin at Hopf's point: circles of radius sqrt(p), of period 2 pi"
  (define rest (continue-equilibrium turning (up 0 0) -1 1))
  (check-equal? (kinds rest) '(Hopf))
  (for ([side '(1 -1)])
    (define circles (switch-branch rest (car (branch-special-points rest)) #:direction side))
    (check-eq? (branch-end circles) 'range)
    (check-true (< 1e-5 (car (branch-parameters circles)) 1e-3))
    (for ([p (branch-parameters circles)] [s (branch-states circles)]
          [T (branch-periods circles)] [stable? (branch-stabilities circles)])
      (check-close (square s) p 1e-9)
      (check-close T (* 2 :pi) 1e-9)
      (check-true stable?))))

;; x' = (p - a) x − x³ beside that spiral
(test-case "of two points within one step the first comes first"
  (define ((both a) p)
    (lambda (s)
      (define x (ref s 2))
      (define spiral ((turning p) s))
      (up (ref spiral 0) (ref spiral 1) (- (* (- p a) x) (cube x)))))
  (for ([a '(-0.02 0.02)] [expected '((pitchfork Hopf) (Hopf pitchfork))])
    (define b
      (continue-equilibrium (both a) (up 0 0 0) -0.5 0.5 #:step 0.3 #:longest-step 2))
    (check-equal? (kinds b) expected)
    (check-close (sort (places b) <) (sort (list a 0) <) 1e-8)))

(test-case "states with a time as well: van der Pol's orbit begins with amplitudes 2 sqrt(damping)"
  (define ((van-der-Pol m) s)
    (up 1 (ref s 2) (- (* (- m (square (ref s 1))) (ref s 2)) (ref s 1))))
  (define rest (continue-equilibrium van-der-Pol (up 0 0 0) -1 1))
  (define cycle (switch-branch rest (car (branch-special-points rest)) #:most-steps 3))
  (define-values (p s) (values (final (branch-parameters cycle)) (final (branch-states cycle))))
  (check-true (< 0 p 0.05))
  (check-close (/ (+ (square (ref s 1)) (square (ref s 2))) (* 4 p)) 1 0.02))

(define ((cusp p) s) (up (+ p (* 3 (ref s 0)) (* -1 (cube (ref s 0))))))
(define hysteresis (continue-equilibrium cusp (up -2.1) -3 3))

(test-case "folds are passed, and located"
  (check-equal? (kinds hysteresis) '(fold fold))
  (check-close (places hysteresis) '(2 -2) 1e-10)
  (check-close (map special-point-state (branch-special-points hysteresis))
               (list (up -1) (up 1)) 1e-10)
  (for ([p (branch-parameters hysteresis)] [s (branch-states hysteresis)])
    (check-close (ref ((cusp p) s) 0) 0 1e-8)))

(test-case "two lines that cross at a transcritical point"
  (define ((logistic p) s) (up (* (ref s 0) (- p (ref s 0)))))
  (define b (continue-equilibrium logistic (up 0.01) -1 1))
  (check-equal? (kinds b) '(transcritical))
  (define other (switch-branch b (car (branch-special-points b))))
  (for ([p (branch-parameters other)] [s (branch-states other)]) (check-close (ref s 0) p 1e-9)))

(test-case "where no energy is lost frequencies meet and oscillations grow: Krein's collision"
  ;; two unit masses, stable by gyroscopic forces 2 G v over a hill -(x² + y²)/2 while G > 1
  (define ((hill G) s)
    (define-values (q v) (values (coordinate s) (velocity s)))
    (up 1 v (up (+ (ref q 0) (* 2 G (ref v 1))) (- (ref q 1) (* 2 G (ref v 0))))))
  (define b (continue-equilibrium hill (up 0 (up 0 0) (up 0 0)) 1.5 0.5))
  (check-equal? (kinds b) '(Krein-collision))
  (check-close (places b) '(1) 1e-6))

(test-case "a branch goes on: with more steps, further, and after a break"
  (define short (continue-equilibrium cusp (up -2.1) -3 3 #:most-steps 10))
  (check-eq? (branch-end short) 'steps)
  (check-equal? (branch-parameters (extend-branch short #:most-steps 500))
                (branch-parameters hysteresis))
  (define further (extend-branch (continue-equilibrium bead (up 0 0 0) 1 2) #:to 4))
  (check-equal? (kinds further) '(pitchfork))
  (define calls 0)
  (define (broken p)
    (set! calls (+ calls 1))
    (when (= calls 60) (raise (exn:break "break" (current-continuation-marks) void)))
    (cusp p))
  (define part
    (with-handlers ([exn:break? branch-so-far]) (continue-equilibrium broken (up -2.1) -3 3)))
  (check-true (branch? part))
  (check-close (final (branch-parameters (extend-branch part))) 3 1e-12))

(test-case "a branch that ends says why, with the last good point"
  (define ((root p) s) (up (- (sqrt (- 1 p)) (* 2 (- 1 p)) (ref s 0))))
  (define b (continue-equilibrium root (up 0.0) 0 2))
  (check-eq? (branch-end b) 'no-next-point)
  (check-close (final (branch-parameters b)) 1 1e-2)
  (check-regexp-match #rx"end +stable.*\n  it ends there: .*real numbers" (format "~a" b)))

(test-case "what it prints"
  (check-equal?
   (format "~a" (continue-equilibrium cusp (up -2.1) -3 3 #:most-steps 1 #:step 0.1))
   (string-append "branch of 2 equilibria\n"
                  "  parameter                          state\n"
                  "  -3.0                start  stable  (up -2.1038034027355366)\n"
                  "  -2.940010712508106  end    stable  (up -2.0979456630778914)\n"
                  "  more follows: (extend-branch b) goes on")))

(test-case "a diagram: solid where stable, dashed where not"
  (define f (frame -3 3 -3 3))
  (plot-branch f hysteresis (lambda (s) (ref s 0)))
  (check-equal? (length (frame-curves f)) 3)
  (check-equal? (length (frame-points f)) 2))

;; The last step goes from -1/21 to 1/21, or back.
(test-case "a branch ends where its range does, within the last step, upwards and downwards"
  (define ((sine p) s) (up (sin (- (ref s 0) p))))
  (for ([from '(-1 1)])
    (define b
      (continue-equilibrium sine (up from) from 0 #:step 0.9535706 #:longest-step 0.9535706))
    (check-close (cadr (reverse (branch-parameters b))) (/ from 21) 1e-6)
    (check-equal? (final (branch-parameters b)) 0.0)
    (check-close (final (branch-states b)) (up 0) 1e-12)))

(define (never p) (lambda (s) (up (+ 1 (square (ref s 0))))))
(test-case "an equilibrium that is none"
  (check-message
   (string-append "continue-equilibrium: no equilibrium was found near the state\n  parameter: 0\n"
                  "  state: (up 0.5)\n  rates there: (up 1.25)")
   (continue-equilibrium never (up 0.5) 0 1)
   (lambda (e) (not (exn:fail:mechanics:not-convergent-error-estimate e)))))

(says
 [(continue-equilibrium cusp (up -2.1) 1 1)
  "continue-equilibrium: expected two values of the parameter, from one to the other\n"
  "  given: the number 1 and the number 1"]
 [(continue-equilibrium (lambda (p) p) (up -2.1) 1 2)
  "continue-equilibrium: the family makes no state derivative of the parameter\n"
  "  given: a function without a name, which takes 1 argument\n  of 1: the number 1\n"
  "  (lambda (p) (Lagrangian->state-derivative (L p))) is one"]
 [(switch-branch hysteresis (car (branch-special-points hysteresis)))
  "switch-branch: no other branch of equilibria leaves a point of this kind: fold\n"
  "  pitchfork, transcritical, Hopf and period-doubling points have one"]
 [(extend-branch hysteresis #:to 2)
  "extend-branch: the branch has left that range of the parameter; #:to says how far it is to go\n"
  "  parameter at its end: 3.0\n  range: from -3.0 to 2.0"]
 [(branch-parameters 3)
  "branch-parameters: expected a branch, such as continue-equilibrium gives\n"
  "  given: the number 3"])
