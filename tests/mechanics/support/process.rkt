#lang racket/base
;; Processes of the system, by their numbers.

(require racket/port
         racket/system
         "patience.rkt")

(provide gone?)

;; A process that has been killed may take a moment to disappear.
(define (gone? number)
  (eventually (not (parameterize ([current-error-port (open-output-nowhere)])
                     (system (format "kill -0 ~a" number))))))
