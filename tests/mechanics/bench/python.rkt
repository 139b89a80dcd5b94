#lang racket/base
;; Programs in Python, to compare with.

(require racket/port)

(provide python)         ; program -> the number it prints, or why there is none

;; What the program prints; SymPy writes out trees, and may take for ever.
(define (python program)
  (define interpreter (find-executable-path "python3"))
  (cond
    [(not interpreter) "no Python"]
    [else
     (define-values (process out in err)
       (parameterize ([current-subprocess-custodian-mode 'kill])
         (subprocess #f #f #f interpreter "-c" program)))
     (close-output-port in)
     (define finished? (sync/timeout 60 process))
     (unless finished? (subprocess-kill process #t))
     (define text (string-append (port->string out)))
     (define complaint (port->string err))
     (close-input-port out)
     (close-input-port err)
     (cond [(not finished?) "> 60 s"]
           [(regexp-match #rx"ModuleNotFoundError" complaint) "not installed"]
           [(regexp-match #px"\\d+" text) => car]
           [else "failed"])]))
