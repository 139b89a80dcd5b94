#lang mechanics
;; Exercise 3.14 (SICM 3.11): the periodically driven pendulum
;; Checked: where the pendulum upside down is stable, and where doubling begins
;; How: traces of the one-period map, by Floquet multipliers; against the averaged potential

(require mechanics/book
         (only-in racket/base real-part))

;; Length 9.8 m, so that ω₀ = 1 rad/s: amplitude A in metres, frequency ω in rad/s.
(define-values (m l g) (values 1. 9.8 9.8))
(define (trace A omega theta)
  (define all
    (Floquet-multipliers (H-pend-sysder m l g A omega) (up 0 theta 0) (/ :2pi omega)))
  (real-part (apply + all)))

;; Upside down it is stable where the size of the trace is less than 2.
(define (upright A omega) (trace A omega :pi))

;; An attempt, for fast drives: the mean of the drive holds it if (A/l)(ω/ω₀) > √2.  A slip
;; takes 1 for √2.
(define omega 100.)
(define (critical-amplitude)
  (define-values (low high) (values 0.05 0.25))
  (bisect (lambda (A) (- (upright A omega) 2)) low high 1e-6))
(define found (* (/ (critical-amplitude) l) omega))
(list found (sqrt 2))

;; The pendulum that hangs doubles its period where the trace passes −2: near ω = 2 ω₀,
;; from below 2 to above it.
(define (hanging A omega) (trace A omega 0))
(define doubling-begins (bisect (lambda (omega) (+ (hanging 0.98 omega) 2)) 2.15 2.6 1e-8))
(define doubling-ends (bisect (lambda (omega) (+ (hanging 0.98 omega) 2)) 1.6 2.0 1e-8))
(list doubling-ends doubling-begins)

(module+ test
  (require rackunit)
  (test-case "the averaged potential tells when it stands upside down"
    (check-= found (sqrt 2) 2e-3)
    (check-true (> (abs (- found 1)) 0.4))
    (check-true (> (upright 0.05 omega) 2))
    (check-true (< (abs (upright 0.25 omega)) 2)))
  (test-case "between two frequencies on both sides of 2 the period is doubled"
    (check-true (< doubling-ends 2 doubling-begins))
    (check-true (< (hanging 0.98 2.) -2))
    (check-true (< (abs (hanging 0.98 (+ doubling-begins 0.05))) 2))))
