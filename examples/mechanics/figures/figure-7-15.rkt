#lang mechanics
;; Where the pendulum on its head is stable  (SICM 7.4.5, Figure 7.15)
;;
;; A grid of drives: the frequency in units of that of small swings across, the amplitude in units
;; of the length up, both by their decimal logarithms.  A dot where the linearized motion about the
;; top, followed for a period of the drive, stays bounded; the line is what the averaged Hamiltonian
;; says, (ω/ω_s)(A/l) = √2.  Above A/l = 0.45 the top is lost again, to a resonance at half the
;; frequency of the drive that no average knows of.

(require mechanics/plot)

;; A displacement x of the top in units τ = ωt of time: D²x = (1/ν² − a cos τ) x with ν = ω/ω_s and
;; a = A/l.  Areas are kept, so all depends on the trace of what a period does to displacements.
(define ((displacement nu a) (up tau x v))
  (up 1 v (* x (- (/ 1 (square nu)) (* a (cos tau))))))
(define (trace-of-a-period nu a)
  (define advance (state-advancer displacement nu a))
  (define (end x v) (advance (up 0. x v) :2pi 1e-8))
  (+ (coordinate (end 1. 0.)) (velocity (end 0. 1.))))
(define (stable? nu a) (< (abs (trace-of-a-period nu a)) 2))

(define picture
  (frame 0 2 -2 0 #:width 450 #:height 450 #:x-label "log ω/ω_s" #:y-label "log A/l"))
(define n 40)
(for* ([i n] [j n])
  (define-values (x y) (values (* 2. (/ (+ i 1/2) n)) (- (* 2. (/ (+ j 1/2) n)) 2)))
  (when (stable? (expt 10 x) (expt 10 y)) (plot-point picture x y #:size 3)))
(plot-line picture (log (sqrt 2) 10) 0 2 (- (log (sqrt 2) 10) 2) #:color 'red)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-15.png"))

(module+ test
  (require rackunit)
  (test-case "the boundary is the average's where the drive is fast, the better the faster"
    (define (critical nu)               ; amplitude, by halving
      (let halve ([low 0.] [high (/ 2. nu)])
        (define half (* 1/2 (+ low high)))
        (cond [(< (- high low) 1e-8) half]
              [(stable? nu half) (halve low half)]
              [else (halve half high)])))
    (define (off nu) (- (/ (* nu (critical nu)) (sqrt 2)) 1))
    (check-= (off 10) 0 0.01)
    (check-= (off 100) 0 1e-4)
    ;; its error is of the second order in 1/ν
    (check-= (/ (off 10) (off 20)) 4 0.1))
  (test-case "the upper boundary of fast drives is that of Mathieu's equation, q = 0.908"
    (check-true (stable? 100 (- (/ 0.90805 2) 0.001)))
    (check-false (stable? 100 (+ (/ 0.90805 2) 0.001)))
    ;; there displacements change sign in each period: the trace is −2
    (check-= (trace-of-a-period 1000 (/ 0.908046 2)) -2 1e-4))
  (test-case "as many dots as stable nodes, none below the line by more than a cell"
    (for ([dot (frame-points picture)])
      (check-true (> (+ (ref dot 0) (ref dot 1)) (- (log (sqrt 2) 10) 0.05))))))
