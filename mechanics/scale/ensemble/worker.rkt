#lang racket/base
;; A worker: a process of its own, which is sent a task and then batches of starts, and sends
;; back what came of them.  It ends when its input does, or is killed: what interrupts us, as
;; Ctrl-C does at a terminal, reaches it as well, and is not its affair.

(require "batch.rkt" "perform-task.rkt" "task.rkt")

(module+ main (parameterize-break #f (work (current-input-port) (current-output-port))))

(define (work in out)
  (define perform (performer 'evolve-ensemble (datum->task (receive in))))
  ;; What is printed by chance must not meet the messages.
  (parameterize ([current-output-port (current-error-port)])
    (let loop ()
      (define b (receive in))
      (unless (eof-object? b)
        (send (with-handlers ([exn:fail? (lambda (e) (trouble (exn-message e)))])
                (perform-batch perform b))
              out)
        (loop)))))
