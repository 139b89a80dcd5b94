#lang mechanics
;; How well energy and angular momentum are kept  (SICM 2.8.1, Figure 2.2)
;;
;; Both are conserved: what changes is the error of the integration in Euler angles, relative to
;; their values, and of the size of 1e-13.

(require mechanics/plot mechanics/book)

(define-values (A B C) (values 1.0 (sqrt 2.0) 2.0))
(define state0 (up 0.0 (up 1.0 0.0 0.0) (up 0.1 0.1 0.1)))
(define L0 ((L-space-Euler A B C) state0))
(define E0 ((T-body-Euler A B C) state0))

(define win (frame 0.0 100.0 -1e-12 1e-12 #:width 600 #:height 300 #:x-label "t"))

(define last-state
  ((evolve rigid-sysder A B C) state0 (monitor-errors win A B C L0 E0) 0.1 100.0 1e-13))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-2-2.png"))

(module+ test
  (require rackunit)
  (define errors (map (lambda (p) (ref p 1)) (frame-points win)))
  (test-case "four errors at each tenth of a second, all below 1e-12"
    (check-equal? (length errors) 4004)
    (for ([e errors]) (check-true (< (abs e) 1e-12))))
  (test-case "the place after 100 s"
    (check-= (ref last-state 1 0) .6319896958326486 1e-10)
    (check-= (ref last-state 1 2) 17.43790048473838 1e-10))
  (test-case "they are rounding: both are conserved"
    (define state (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))
    (define T (T-body-Euler 'A 'B 'C))
    (check-pred proved? (verify-conserved T T state))
    (check-pred proved? (verify-conserved T (L-space-Euler 'A 'B 'C) state))))
