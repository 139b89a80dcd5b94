#lang racket/base
;; The square of the decimal √9.8 happens to be 9.8 for flonums, so that the residual of a motion
;; with it was formed as 0, and *proved* was told without a word of the decimals.

(require mechanics
         "../support/checks.rkt")

(define ((L k) (up t x v)) (- (* 1/2 (square v)) (* 1/2 k (square x))))
(define ((H k) (up t x p)) (+ (* 1/2 (square p)) (* 1/2 k (square x))))
(define ((oscillation amplitude omega) t) (* amplitude (cos (* omega t))))
(define ((momentum amplitude omega) t) (* -1 omega amplitude (sin (* omega t))))
(define decimal (sqrt 9.8))

;; Racket's own product, of which the library knows nothing
(define odd-frequency 1.1234567890123457)
(define odd-stiffness (* odd-frequency odd-frequency))

(define-check (check-read v readings)
  (with-check-info (['verdict v])
    (unless (and (proved? v) (equal? (format "~s" (verdict-readings v)) (format "~s" readings)))
      (fail-check))))

(test-case "readings that a proof rests on are told"
  (define readings '((3.1304951684997055 (* 7/5 (sqrt 5))) (4.9 49/10)))
  (check-equal? (* decimal decimal) 9.8)
  (check-read (verify-solution (L 9.8) (oscillation 'A decimal)) readings)
  (check-read (verify-Hamiltonian-solution (H 9.8) (oscillation 'A decimal) (momentum 'A decimal))
              readings)
  (check-pred refuted? (verify-solution (L 9.7) (oscillation 'A decimal))))

(test-case "a proof for any numbers in place of its decimals needs none"
  (check-read (verify-solution (L 'k) (oscillation 0.3 (sqrt 'k))) '())
  (check-read (verify-conserved (L 9.8) (lambda ((up t x v)) (+ (square v) (* 9.8 (square x))))
                                (up 't 'x 'v))
              '()))

(test-case "decimals that are no readable numbers are no proof"
  (define v (verify-solution (L odd-stiffness) (oscillation 'A odd-frequency)))
  (check-pred undecided? v)
  (check-equal? (verdict-reason v) 'decimals))
