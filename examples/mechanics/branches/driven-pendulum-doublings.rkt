#lang mechanics
;; A damped pendulum that is driven harder and harder: its symmetric swing becomes lopsided, and the
;; lopsided one takes two periods of the drive, then four, on the way to chaos.

(define ((pendulum A) (up t theta rate))
  (up 1 rate (+ (- (sin theta)) (* -1/2 rate) (* A (cos (* 2/3 t))))))
(define drive-period (* 3 :pi))

(define symmetric
  (continue-periodic-orbit pendulum (up 0 0.5 0) drive-period 0.5 1.12))
symmetric

(define (first-special b) (car (branch-special-points b)))
(define lopsided (switch-branch symmetric (first-special symmetric)))
lopsided
(define twice (switch-branch lopsided (first-special lopsided)))
twice
(define four-times (switch-branch twice (first-special twice) #:most-steps 30))

;; Feigenbaum: each interval of the drive is about 4.67 times shorter than the one before.
(define amplitudes
  (map (lambda (b) (special-point-parameter (first-special b)))
       (list lopsided twice four-times)))
amplitudes

(module+ test
  (require rackunit)
  (test-case "broken symmetry, then doublings, each with twice the period"
    (check-eq? (special-point-kind (first-special symmetric)) 'pitchfork)
    (for ([b (list lopsided twice four-times)] [n '(1 2 4)])
      (check-eq? (special-point-kind (first-special b)) 'period-doubling)
      (check-= (car (branch-periods b)) (* n drive-period) 1e-9)))
  (test-case "the intervals shrink"
    (define-values (a b c) (apply values amplitudes))
    (check-true (< 3.5 (/ (- b a) (- c b)) 6))))
