#lang racket/base
;; Measurements, each in fresh processes.

(require compiler/find-exe
         racket/port
         racket/runtime-path
         "clock.rkt")

(provide measure        ; name runs -> list of what child.rkt wrote, or of strings
         load-times)    ; arguments-list runs -> list of lists of CPU milliseconds

(define-runtime-path child "child.rkt")

;; A run that fails gives the first line of its complaint.
(define (measure name runs)
  (for/list ([_ (in-range runs)])
    (define-values (output complaint)
      (run (list (path->string child) (symbol->string name))))
    (define result (read (open-input-string output)))
    (if (eof-object? result)
        (read-line (open-input-string (string-append complaint "\nno result")))
        result)))

;; CPU milliseconds of racket with each list of arguments, taken in turns so
;; that a change of the machine's pace meets all alike.
(define (load-times arguments-list runs)
  (define rows
    (for/list ([_ (in-range runs)])
      (for/list ([arguments (in-list arguments-list)])
        (define start (processes-milliseconds))
        (run arguments)
        (- (processes-milliseconds) start))))
  (apply map list rows))

(define (run arguments)
  (define-values (process out in err)
    (parameterize ([current-subprocess-custodian-mode 'kill])
      (apply subprocess #f #f #f (find-exe) arguments)))
  (close-output-port in)
  (define complaint (open-output-string))
  (define reader (thread (lambda () (copy-port err complaint))))
  (define output (port->string out))
  (subprocess-wait process)
  (thread-wait reader)
  (close-input-port out)
  (close-input-port err)
  (values output (get-output-string complaint)))
