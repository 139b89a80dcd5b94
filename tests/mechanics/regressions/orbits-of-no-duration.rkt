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
