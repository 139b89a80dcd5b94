#lang mechanics
;; Exercise 3.14 (SICM 3.11): the periodically driven pendulum
;; Checked: where the pendulum upside down is stable, what doubling leads to, how far chaos comes
;; How: traces of the one-period map, by Floquet multipliers; periodic points and orbits followed

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

;; At this amplitude it leads to a stable motion of two periods, through θ = 0 with momenta
;; ±p in turn.  Where the frequency has come down by d from where doubling begins, p grows as √d.
(define (doubled omega theta p)
  (find-fixed-point (driven-pendulum-map m l g 0.98 omega) (up theta p) #:period 2))
(define (momentum-through-0 omega)
  (ref (fixed-point-coordinates (doubled omega 0. 110.)) 1))
(define momenta (map momentum-through-0 '(2.2 2. 1.8)))
momenta

;; It outlives the range: below, where the pendulum that hangs is stable again, it is still there,
;; and between the two an unstable one that rests at angles ±θ.  A slip: that it has ended.
(define between (doubled 1.8 0.6 0.))
(list (fixed-point-kind between) (ref (fixed-point-coordinates between) 0))

;; How far chaos comes: an orbit from near the top, at ω = 4.2, is about the separatrix until the
;; drive is strong enough; then it comes beyond the islands that go round with the drive, where
;; p = m l² ω.
(define (greatest-momentum A)
  (define T (driven-pendulum-map m l g A 4.2))
  (define most
    (for/fold ([theta 3.1] [p 0.] [most 0.] #:result most) ([k 2000])
      (T theta p (lambda (theta p) (values theta p (max most (abs p)))) void)))
  (/ most (* m (square l) 4.2)))
(define reached (map (lambda (part) (greatest-momentum (* part l))) '(0.02 0.04 0.08)))
reached

(module+ test
  (require rackunit)
  (test-case "the averaged potential tells when it stands upside down"
    (check-= found (sqrt 2.0) 2e-3)
    (check-true (> (abs (- found 1)) 0.4))
    (check-true (> (upright 0.05 omega) 2))
    (check-true (< (abs (upright 0.25 omega)) 2)))
  (test-case "between two frequencies on both sides of 2 the period is doubled"
    (check-true (< doubling-ends 2 doubling-begins))
    (check-true (< (hanging 0.98 2.) -2))
    (check-true (< (abs (hanging 0.98 (+ doubling-begins 0.05))) 2)))
  (test-case "the doubled motion begins as a root, and is stable"
    (define (square-for d) (square (momentum-through-0 (- doubling-begins d))))
    (check-= (/ (square-for 0.02) (square-for 0.005)) 4 0.1)
    (check-true (apply < momenta))
    (for ([omega '(2.2 2. 1.8)])
      (check-equal? (fixed-point-kind (doubled omega 0. 110.)) 'elliptic)))
  (test-case "below the range hanging and doubled are both stable, with an unstable one between"
    (check-true (< 1.8 doubling-ends))
    (check-true (< (abs (hanging 0.98 1.8)) 2))
    (check-equal? (fixed-point-kind between) 'hyperbolic)
    (check-= (ref (fixed-point-coordinates between) 1) 0 1e-8)
    (check-true (> (abs (ref (fixed-point-coordinates between) 0)) 0.3)))
  (test-case "the chaotic zones are linked at A = 0.08 l, not at 0.04 l"
    (check-true (< (car reached) (cadr reached) 0.8))
    (check-true (> (caddr reached) 1.2))))
