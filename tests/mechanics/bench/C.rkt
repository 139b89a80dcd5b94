#lang racket/base
;; Programs in C, compiled and run, to compare with.

(require racket/file racket/port)

(provide run-C)          ; files text arguments -> what it prints, or why there is none

;; The program of some files and a text, with its arguments, prints a list.  All that is
;; made is removed.
(define (run-C files text arguments)
  (define compiler (or (find-executable-path "cc") (find-executable-path "gcc")))
  (cond [(not compiler) "no C compiler"]
        [else
         (define folder (make-temporary-file "bench~a" 'directory))
         (dynamic-wind
          void
          (lambda () (compile-and-run compiler folder files text arguments))
          (lambda () (delete-directory/files folder)))]))

(define (compile-and-run compiler folder files text arguments)
  (define source (build-path folder "given.c"))
  (define program (build-path folder "program"))
  (display-to-file text source)
  (define complaint
    (apply output-of compiler
           `("-O2" "-ffp-contract=off" "-o" ,program ,@files ,source "-lm")))
  (cond [(file-exists? program)
         (define value (read (open-input-string (apply output-of program arguments))))
         (if (list? value) value "failed")]
        [else
         (eprintf "~a" complaint)
         "not compiled"]))

(define (output-of program . arguments)
  (define-values (process out in err)
    (parameterize ([current-subprocess-custodian-mode 'kill])
      (apply subprocess #f #f 'stdout program arguments)))
  (close-output-port in)
  (define output (port->string out))
  (subprocess-wait process)
  (close-input-port out)
  output)
