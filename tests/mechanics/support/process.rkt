#lang racket/base
;; Processes of the system, by their numbers.

(require racket/port
         racket/system)

(provide gone?)

;; A process that has been killed may take a moment to disappear.
(define (gone? number)
  (for/or ([_ (in-range 50)])
    (sleep 0.1)
    (not (parameterize ([current-error-port (open-output-nowhere)])
           (system (format "kill -0 ~a" number))))))
