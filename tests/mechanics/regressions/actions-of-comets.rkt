#lang racket/base
;; The radial action and the frequencies of very eccentric orbits were integrals that "did not
;; converge", and orbits far longer than their nearest distance "did not turn back".  Next to the
;; nearest point the energy was a small difference of large numbers.

(require mechanics
         "../support/checks.rkt" "../support/separated-Kepler.rkt")

;; By the energy without rounding: J = 1/√(−2E) − L, both frequencies (−2E)^(3/2)
(define (check-orbit r p_r L)
  (define s (up 0 (up r 0.2) (down p_r L)))
  (define -2E (exact->inexact (* -2 (Kepler (up 0 (up (inexact->exact r) 0)
                                                (down (inexact->exact p_r) (inexact->exact L)))))))
  (define n (* -2E (sqrt -2E)))
  (define (close x y) (check-= (/ x y) 1 1e-10))
  (close (ref (separation-actions separated-Kepler s) 0) (- (/ 1 (sqrt -2E)) L))
  (define omegas (separation-frequencies separated-Kepler s))
  (close (ref omegas 0) n)
  (close (ref omegas 1) n))

(define nearly-1 '(1e-2 1e-3 1e-5 1e-6 1e-8 1e-10 1e-12))         ; 1 − e

(test-case "from the farthest point, from the middle and from the nearest"
  (for ([d nearly-1])
    (define L (sqrt (* d (- 2 d))))
    (check-orbit (- 2.0 d) 0.0 L)
    (check-orbit 1.0 (sqrt (- 1 (* L L))) L)
    (check-orbit d 0.0 (* (- 1 1e-12) L))))

(test-case "with the nearest distance as the unit of length"
  (for ([d nearly-1] #:when (>= d 1e-10))
    (check-orbit 1.0 0.0 (sqrt (- 2 d)))))
