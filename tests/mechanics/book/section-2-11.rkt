#lang racket/base
;; SICM 2.11, Spin-Orbit Coupling (pp. 165-181), with the time in orbits.

(require mechanics
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define orbit (* 2 pi))

;; ---------------------------------------------------------------------------
;; The equation

(define-values (a/R f theta) (apply values (map literal-function '(a/R f theta))))

(test-case "p. 171: the equation of motion"
  (check-prints (((Lagrange-equations (L-spin-orbit 'C 'n 'epsilon a/R f)) theta) 't)
                '(- (* C (((expt D 2) theta) t))
                    (* 1/2 C (expt epsilon 2) (expt n 2) (expt (a/R t) 3)
                       (sin (* 2 (- (f t) (theta t))))))))

(test-case "the state derivative is that of the Lagrangian on the orbit"
  (define distance (lambda (t) (/ (+ 1 (* 'e (cos (f t)))) (- 1 (square 'e)))))
  (define rates ((spin-orbit-sysder 'n 'epsilon 'e) (up 't 'theta 'thetadot (f 't))))
  (check-identity (ref rates 2)
                  ((Lagrangian->acceleration (L-spin-orbit 'C 'n 'epsilon distance f))
                   (up 't 'theta 'thetadot)))
  (check-identity (ref rates 1) 'thetadot))

(test-case "the anomaly moves so that equal areas are swept, once round in an orbit"
  (define rates ((spin-orbit-sysder 'n 'epsilon 'e) (up 't 'theta 'thetadot 'f)))
  (define R (/ (- 1 (square 'e)) (+ 1 (* 'e (cos 'f)))))
  (check-identity (* (square R) (ref rates 3)) (* 'n (sqrt (- 1 (square 'e)))))
  (define s ((state-advancer spin-orbit-sysder orbit 0.1 0.3) (up 0 0 0 0) 1 1e-13))
  (check-= (ref s 3) orbit 1e-11))

(test-case "out of roundness"
  (check-prints (out-of-roundness 'A 'B 'C) '(sqrt (/ (* 3 (- B A)) C))))

(test-case "on a circle it is a pendulum in theta - n t"
  (define L (L-spin-orbit 'C 'n 'epsilon (lambda (t) 1) (lambda (t) (* 'n t))))
  (define (energy s) (- (* 1/2 'C (square (- (velocity s) 'n)))
                        (* 1/4 'C (square (* 'n 'epsilon))
                           (cos (* 2 (- (coordinate s) (* 'n (time s))))))))
  (check-pred proved? (verify-conserved L energy (up 't 'theta 'thetadot))))

;; ---------------------------------------------------------------------------
;; The Moon (figures of p. 175)

(define (follow epsilon e rate start orbits [events '()])
  (evolve-trajectory (spin-orbit-sysder orbit epsilon e) (up 0 start (* rate orbit) 0) orbits
                     #:tolerance 1e-13 #:events events))

;; The angle between the long axis and the line to the planet
(define (off-line s) (- (ref s 1) (ref s 3)))

(define (greatest-swing motion orbits)
  (for/fold ([swing 0]) ([t (in-range 0 orbits 1/50)]) (max swing (abs (off-line (motion t))))))

(test-case "its libration takes 40.016 orbits, on a circle"
  (define moon (follow .026 0 1.01 0 50 (event off-line)))
  (define crossings
    (for/list ([o (trajectory-events moon)]) (time (occurrence-state o))))
  (check-close crossings (list (/ 40.01601442 2) 40.01601442) 1e-6)
  (define quarter (moon (/ 40.01601442 4)))
  (check-= (off-line quarter) .3947911197 1e-8)
  (check-true (<= (greatest-swing moon 50) .3947911198)))

(test-case "on its ellipse the yearly swing is added"
  (define moon (follow .026 .05 1.01 0 50))
  (check-true (< .45 (greatest-swing moon 50) .55)))

;; ---------------------------------------------------------------------------
;; Hyperion and Mercury

;; The mean rate at which two motions part that start 1e-9 from each other
(define (parting epsilon e rate orbits)
  (define (from start) (follow epsilon e rate start orbits))
  (define-values (a b) (values (from 0.) (from 1e-9)))
  (/ (log (/ (abs (- (ref (a orbits) 1) (ref (b orbits) 1))) 1e-9)) orbits))

(test-case "Hyperion tumbles: motions part exponentially"
  (check-true (> (parting .89 .1 1.05 15) 0.5))
  (check-true (< (parting .026 .05 1.01 15) 0.25)))

(test-case "the exponent is positive over a long time, started afresh each orbit"
  (define advance (state-advancer spin-orbit-sysder orbit .89 .1))
  (define apart 1e-8)
  (define-values (_s _r sum)
    (for/fold ([s (up 0 0. (* 1.05 orbit) 0.)] [offset (up 0 apart 0. 0.)] [sum 0])
              ([_ 200])
      (define-values (here there) (values (advance s 1 1e-11) (advance (+ s offset) 1 1e-11)))
      (define d (- there here))
      (define size (sqrt (+ (square (ref d 1)) (square (/ (ref d 2) orbit)))))
      (values here (* (/ apart size) d) (+ sum (log (/ size apart))))))
  (check-true (< 0.3 (/ sum 200) 1.5)))

(test-case "Mercury, three turns in two orbits: the rate of its libration"
  (define mercury (follow .026 .2 (* 1.5 1.0005) 0. 100))
  (define (off t) (- (ref (mercury t) 1) (* 3/2 orbit t)))
  ;; From perihelion to perihelion; the first order in e and the next one
  (define half
    (for/first ([t (in-range 2 100 2)] #:when (< (off t) 0)) t))
  (define rate (/ pi half))
  (check-= (* .026 (sqrt (* 7/2 .2))) .02175316069 1e-10)
  (define next (* orbit .026 (sqrt (- (* 7/2 .2) (* 123/16 (cube .2))))))
  (check-= rate next 0.01))

(says
 [((spin-orbit-sysder 1 0.1 1.2) (up 0 0 0 0))
  "spin-orbit-sysder: the eccentricity of an orbit that closes is 0 or more and less than 1; "
  "given the number 1.2"]
 [((spin-orbit-sysder 1 0.1 0.2) (up 0 0 0))
  "spin-orbit-sysder: expected a state (up t theta thetadot f)\n"
  "  given: (up 0 0 0), an up tuple of 3"]
 [(L-spin-orbit 1 1 1 1 f)
  "L-spin-orbit: a/R and f are functions of the time; given the number 1"])
