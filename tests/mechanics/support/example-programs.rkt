#lang racket/base
;; Programs of examples/, run in this process as each runs alone: in a namespace that has the
;; library and no program, and in a thread of its own, whose end is the end of what the program
;; sets.  The library is loaded once for all; a process for each takes several times as long.
;;
;; A program that raises, exits or does not end is a test that fails, and the others go on.

(require rackunit/log
         "checks.rkt" "patience.rkt")

(provide
 loaded-from      ; (loaded-from anchor library ...) -> namespace
 alone            ; (alone name body ...): in a thread; fails by that name, a string
 over-time        ; parameter: an event that stops a body before patience is over
 run-example      ; (run-example namespace program argument ...) -> what it prints
 test-example)    ; (test-example namespace file): its tests, as if they stood here

;; A namespace where the libraries are loaded already, as they are at the anchor, and no
;; program.
(define (loaded-from anchor . libraries)
  (define namespace (make-base-empty-namespace))
  (for ([library (in-list libraries)])
    (namespace-attach-module (namespace-anchor->empty-namespace anchor) library namespace))
  namespace)

;; program : a file, or a submodule of one; arguments : those on its command line
(define (run-example namespace program . arguments)
  (define out (open-output-string))
  (parameterize ([current-namespace namespace]
                 [current-output-port out]
                 [current-command-line-arguments (list->vector arguments)])
    (dynamic-require program #f))
  (get-output-string out))

;; Each check counts where rackunit was attached from.
(define (test-example namespace file)
  (define before (test-log))
  (parameterize ([current-namespace namespace])
    (dynamic-require `(submod ,file test) #f))
  (when (equal? (test-log) before)
    (error 'example "ran no test")))

;; ---------------------------------------------------------------------------

(define over-time (make-parameter never-evt))

(define-syntax-rule (alone name body ...)
  (call-alone name (lambda () body ... (void))))

(define (call-alone name thunk)
  (define (failed what . values) (lambda () (apply error 'example what values)))
  (define outcome (failed "was killed"))
  (define (run)
    (set! outcome
          (let/ec return
            (parameterize ([exit-handler
                            (lambda (code) (return (failed "exited with code ~a" code)))])
              (with-handlers ([void (lambda (e) (lambda () (raise e)))])
                (thunk)
                #f)))))
  (define runner (thread run))
  (sync/patience 300 runner (over-time))
  (unless (thread-dead? runner)
    (kill-thread runner)
    (set! outcome (failed "stopped, for it does not end")))
  (when outcome (test-case name (outcome))))
