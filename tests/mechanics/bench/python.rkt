#lang racket/base
;; Programs in Python, to compare with: in the environment that `make peers` made, or in the
;; system's own.

(require racket/port racket/runtime-path)

(provide python          ; program -> the number it prints, or why there is none
         python/text     ; program -> what it prints, or why there is nothing
         numbers-of)     ; what it prints -> its two numbers, or the text itself

(define-runtime-path environment "../../../build/python/bin/python")

(define (interpreter-path)
  (if (file-exists? environment) environment (find-executable-path "python3")))

(define (python program)
  (define text (python/text program))
  (cond [(regexp-match #px"^\\d+" text) => car]
        [else text]))

;; SymPy writes out trees, and may take for ever.
(define (python/text program)
  (define interpreter (interpreter-path))
  (cond
    [(not interpreter) "no Python"]
    [else
     (define-values (process out in err)
       (parameterize ([current-subprocess-custodian-mode 'kill])
         (subprocess #f #f #f interpreter "-")))
     (write-string program in)
     (close-output-port in)
     (define finished? (sync/timeout 60 process))
     (unless finished? (subprocess-kill process #t))
     (define text (string-append (port->string out)))
     (define complaint (port->string err))
     (close-input-port out)
     (close-input-port err)
     (cond [(not finished?) "> 60 s"]
           [(regexp-match #rx"ModuleNotFoundError" complaint) "not installed"]
           [(regexp-match? #px"\\d" text) text]
           [else "failed"])]))

(define (numbers-of text)
  (define found (regexp-match #px"([0-9.]+) ([0-9.]+)" text))
  (if found (map string->number (cdr found)) text))
