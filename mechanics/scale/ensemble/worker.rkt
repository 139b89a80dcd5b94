#lang racket/base
;; A worker: a process that is sent a task and then batches of starts, and sends back their
;; outcomes.  It ends when its input ends, or is killed; breaks are off in it, for Ctrl-C at a
;; terminal reaches every process.

(require "perform-task.rkt" "task.rkt")

(module+ main (parameterize-break #f (work (current-input-port) (current-output-port))))

(define (work in out)
  (define perform (performer 'evolve-ensemble (receive in)))
  ;; Text that a user's function prints must not come between the messages.
  (parameterize ([current-output-port (current-error-port)])
    (let loop ()
      (define b (receive in))
      (unless (eof-object? b)
        (send (with-handlers ([exn:fail? (lambda (e) (trouble (exn-message e)))])
                (perform-batch perform b))
              out)
        (loop)))))
