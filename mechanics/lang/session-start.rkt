#lang racket/base
;; The settings of a session: how results and errors are printed, and which notes were given.

(require "unknown-name/unknown-names.rkt" "printer.rkt"
         (only-in "../error/note.rkt" start-session-of-notes!))

(provide start-session! set-handlers! error->text)

;; more : advice on how the rest of a long result is seen, as `install-printer!` takes it
(define (start-session! . more)
  (print-as-expression #t)
  (apply set-handlers! more))

;; Idempotent.
(define (set-handlers! . more)
  (apply install-printer! more)
  (install-hints!)
  (start-session-of-notes!))

;; x : raised; otherwise : a template for the text of a value that is no exception
;; -> the text that the session's display of errors prints
(define (error->text x otherwise)
  (define port (open-output-string))
  (parameterize ([current-error-port port])
    ((error-display-handler) (if (exn? x) (exn-message x) (format otherwise x)) x))
  (regexp-replace #rx"\n+$" (get-output-string port) ""))
