#lang racket/base
;; The memory that an ensemble takes: so many bytes for each trajectory that is returned, as the
;; manual says, and none for those that are folded.

(require mechanics
         (only-in mechanics/book L-pendulum)
         "../../support/checks.rkt")

(define swing (Lagrangian->state-derivative (L-pendulum 9.8 1 1)))

;; Starts that nobody keeps
(define (starts n)
  (make-do-sequence
   (lambda () (values (lambda (k) (up 0 (* 1e-4 k) 0)) add1 0 (lambda (k) (< k n)) #f #f))))

(define (kept)
  (collect-garbage)
  (collect-garbage)
  (current-memory-use))

(define many 4000)

;; thunk : -> values of an ensemble, or what they were folded to
(define (bytes-each thunk)
  (define before (kept))
  (define result (thunk))
  (define after (kept))
  (when (list? result) (check-equal? (length result) many))
  (/ (- after before) many 1.0))

(define last-position (lambda (s) (ref s 1)))

(test-case "what is returned takes what the manual says, what is folded nothing"
  (evolve-ensemble swing (starts 100) 1 #:jobs 1)          ; what is loaded and compiled once
  (check-true (< 80 (bytes-each (lambda () (evolve-ensemble swing (starts many) 1 #:jobs 1)))
                 200))
  (check-true (< (bytes-each (lambda () (evolve-ensemble swing (starts many) 1 #:jobs 1
                                                         #:collect last-position)))
                 60))
  (check-true (< (bytes-each (lambda () (evolve-ensemble swing (starts many) 1 #:jobs 1
                                                         #:collect last-position
                                                         #:fold + #:initial 0)))
                 16)))
