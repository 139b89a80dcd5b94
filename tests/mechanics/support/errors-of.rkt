#lang racket/base
;; Errors of a program that is run from a file.

(require compiler/find-exe
         racket/file
         racket/port
         racket/string
         "folder.rkt"
         "run-text.rkt")

(provide errors-of)

;; The errors of running a file my.rkt of these lines, in a folder of its own:
;; a list of lines.
(define (errors-of . text)
  (with-folder (folder)
    (define file (build-path folder "my.rkt"))
    (display-to-file (apply lines text) file)
    (define-values (process out in err)
      (parameterize ([current-directory folder]) (subprocess #f #f #f (find-exe) file)))
    (close-output-port in)
    (define written (port->string err))
    (close-input-port out)
    (close-input-port err)
    (string-split (string-trim written) "\n")))
