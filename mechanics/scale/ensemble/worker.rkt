#lang racket/base
;; A worker: a process that is sent a task and then batches of starts, and sends back their
;; outcomes.  It ends when its input ends, in the middle of a batch and without a word, for then
;; whoever would read its outcomes has ended, or when it is killed; breaks are off in it, for Ctrl-C
;; at a terminal reaches every process.

(require "perform-task.rkt" "task.rkt")

(module+ main (parameterize-break #f (work (current-input-port) (current-output-port))))

(define (work in out)
  (define perform (performer 'evolve-ensemble (receive in)))
  (define worker (current-thread))
  (thread (lambda () (hand-on in worker)))
  ;; Text that a user's function prints must not come between the messages.
  (parameterize ([current-output-port (current-error-port)])
    (let loop ()
      (define b (thread-receive))
      (define answer
        (with-handlers ([exn:fail? (lambda (e) (trouble (exn-message e)))])
          (perform-batch perform b)))
      ;; the reader has ended
      (with-handlers ([exn:fail:filesystem? (lambda (_) (exit 0))])
        (send answer out))
      (loop))))

(define (hand-on in worker)
  (define b (receive in))
  (when (eof-object? b) (exit 0))
  (thread-send worker b)
  (hand-on in worker))
