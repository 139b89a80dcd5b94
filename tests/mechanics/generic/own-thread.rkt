#lang racket/base
;; Work in a thread of its own: its value, what it raises, and how it is given up.

(require mechanics/generic/own-thread
         "../support/checks.rkt" "../support/patience.rkt")

(test-case "the value is given, and what is raised is raised, be it an error or not"
  (check-equal? (call-in-own-thread (lambda () 'value) 60) 'value)
  (check-exn exn:fail? (lambda () (call-in-own-thread (lambda () (car '())))))
  (check-exn symbol? (lambda () (call-in-own-thread (lambda () (raise 'boo)) 60))))

(test-case "work that takes too long is stopped by a break, once it takes one"
  (define done? #f)
  (define (forever)
    (parameterize-break #f (sleep 0.3) (set! done? #t))
    (let loop () (loop)))
  (check-equal? (call-in-own-thread forever 0.1 (lambda () 'late)) 'late)
  (check-true done?))

(test-case "a break of the caller ends the work"
  (define-values (worker begun) (values #f (make-semaphore)))
  (define (forever)
    (set! worker (current-thread))
    (semaphore-post begun)
    (let loop () (loop)))
  (define caller
    (thread (lambda () (with-handlers ([exn:break? void]) (call-in-own-thread forever)))))
  (semaphore-wait begun)
  (break-thread caller)
  (check-equal? (sync/patience 30 caller) caller)
  (check-true (thread-dead? worker)))
