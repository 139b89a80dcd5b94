#lang racket/base
;; A session of cells without a front end: where a notebook is run as it is made, and where a
;; student's is run to be judged.  Nobody types into it, and it does not end at `exit`.

(require (only-in racket/port open-output-nowhere)
         "cell.rkt"
         "../error/complain.rkt"
         "../lang/session-start.rkt"
         "../show/display/receiving-printer.rkt")

(provide call-as-session cell-failure)

(define (call-as-session thunk)
  (parameterize ([current-input-port (open-input-string "")]
                 [exit-handler (lambda (code) (complain 'exit end-in-menu))]
                 [error-display-handler
                  (lambda (message e) (write-string message (current-error-port)))]
                 [current-print (output-receiver void (open-output-nowhere))])
    (start-session!)
    (thunk)))

;; Evaluates a cell in the present namespace; its output is dropped. -> why it failed, or #f
(define (cell-failure source)
  (define failed (call-as-session (lambda () (evaluate-cell source))))
  (and failed (failure-message failed)))
