#lang racket/base
;; Notes in a new session.

(require mechanics/error/note)

(provide told)

;; The notes while the expressions are evaluated.
(define-syntax-rule (told expression ...)
  (let ([port (open-output-string)])
    (define t
      (parameterize ([current-error-port port])
        (thread (lambda () (start-session-of-notes!) expression ... (void)))))
    (thread-wait t)
    (get-output-string port)))
