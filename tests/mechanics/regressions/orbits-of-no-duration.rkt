#lang racket/base
;; Where nothing comes back, the search for a periodic orbit came to one of the period 0.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(test-case "a drift and a motion that runs away have no periodic orbits"
  (define ((drift p) s) (up 1 p))
  (define (runs-away s) (up (+ 1 (square (ref s 0)))))
  (define none ": no periodic orbit was found near the state\n")
  (define (check-none who message)
    (check-true (regexp-match? (string-append "^" who none) message) message))
  (check-none "find-periodic-orbit"
              (message-of (find-periodic-orbit (drift 1/2) (up 0.1 0.2) 1) exn:fail?))
  (check-none "find-periodic-orbit"
              (message-of (find-periodic-orbit runs-away (up 0.1) 1) exn:fail?))
  (check-none "continue-periodic-orbit"
              (message-of (continue-periodic-orbit drift (up 0.1 0.2) 1 1 2) exn:fail?)))

;; A limit cycle of the radius 1e-8, ten thousand times a second round: shorter than a millionth
(test-case "a short orbit that returns is one"
  (define-values (radius omega) (values 1e-8 1e4))
  (define (turns s)
    (define-values (x y) (values (ref s 0) (ref s 1)))
    (define growth (* omega (- 1 (/ (+ (square x) (square y)) (square radius)))))
    (up (- (* growth x) (* omega y)) (+ (* growth y) (* omega x))))
  (define o (find-periodic-orbit turns (up radius 0.0) (/ 6.3 omega)))
  (check-= (periodic-orbit-period o) (/ 6.283185307179586 omega) 1e-9))
