#lang racket/base
;; Seeded randomness: a test names its seed, and a failure prints it.

(require "checks.rkt")

(provide with-seed with-seeds
         random-integer random-rational random-flonum random-complex random-choice)

;; (with-seed number body ...): the body's random numbers follow from the seed.
;; (with-seeds n body ...): with each of the seeds 1 ... n.
(define-syntax-rule (with-seed number body ...)
  (let ([s number])
    (parameterize ([current-pseudo-random-generator (make-pseudo-random-generator)])
      (random-seed s)
      (with-check-info (['seed s]) body ...))))

(define-syntax-rule (with-seeds n body ...)
  (for ([seed (in-range 1 (+ n 1))])
    (with-seed seed body ...)))

(define (random-integer low high) (+ low (random (- high low -1))))

;; Never zero, so that one may divide by it.
(define (random-rational)
  (define p (random-integer -9 9))
  (if (zero? p) (random-rational) (/ p (random-integer 1 7))))

;; Of moderate size and away from zero.
(define (random-flonum)
  (* (if (zero? (random 2)) 1.0 -1.0) (+ 0.1 (* 3.0 (random)))))

(define (random-complex) (make-rectangular (random-flonum) (random-flonum)))

(define (random-choice . choices) (list-ref choices (random (length choices))))
