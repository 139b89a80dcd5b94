#lang racket/base
;; The settings of a session: how results and errors are printed, and which notes were given.

(require "unknown-name/unknown-names.rkt" "printer.rkt"
         (only-in "../error/note.rkt" start-session-of-notes!))

(provide start-session! set-handlers!)

;; more : advice on how the rest of a long result is seen, as `install-printer!` takes it
(define (start-session! . more)
  (print-as-expression #t)
  (apply set-handlers! more))

;; Idempotent.
(define (set-handlers! . more)
  (apply install-printer! more)
  (install-hints!)
  (start-session-of-notes!))
