#lang racket/base
;; The program of a submission's process (teaching/class/evaluate.rkt): it reads a request from one
;; port and answers on the other.

(require "../../notebook/cell-session.rkt"
         "../../teaching/class/evaluate.rkt" "../../teaching/class/open-program.rkt"
         "../unknown-name/unknown-names.rkt" "../wrong-call/marked-line.rkt")

;; Failures in our words, with the line of the form that was evaluated; an unreadable form has
;; its line.  An exception may be made by somebody who wishes us ill: its message is at hand.
(define (words-with-line e)
  (define message (exn-message e))
  (define text
    (if (exn:fail:read? e)
        message
        (with-handlers ([void (lambda (_) message)]) (explained message e #f))))
  (define line (marked-line (exn-continuation-marks e)))
  (if (and line (not (regexp-match? #rx"^program:" text)))
      (format "line ~a: ~a" (cdr line) text)
      text))

(parameterize ([failure-words words-with-line])
  (evaluate-request (current-input-port) (current-output-port) cell-failure))
