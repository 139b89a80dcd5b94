#lang racket/base
;; Programs that open windows, run in a process of their own that has a display, or a
;; program, Xvfb, that stands for one.

(require compiler/find-exe
         racket/file
         racket/port
         racket/string
         "checks.rkt" "skip.rkt")

(provide
 run-program         ; (run-program file environment argument ...) -> what it prints, a string
 environment-with    ; (environment-with display) -> environment variables
 run-without-display ; (run-without-display file who) -> what it prints; who's refusals in that
 call-with-display   ; (call-with-display use) : (use display); the file SCREEN_FILE has its pixels
 display-server      ; -> path or #f
 test-windows)       ; (test-windows name program expected argument ...)

(define (run-program program environment . arguments)
  (parameterize ([current-environment-variables environment]
                 [current-subprocess-custodian-mode 'kill])
    (define-values (process out in err)
      (apply subprocess #f #f 'stdout (find-exe) (path->string program) arguments))
    (close-output-port in)
    (begin0 (port->string out)
            (subprocess-wait process)
            (close-input-port out))))

(define (environment-with display)
  (define copy (environment-variables-copy (current-environment-variables)))
  (environment-variables-set! copy #"DISPLAY" display)
  copy)

;; who : the procedure that would open a window
(define (run-without-display program who)
  (define output (run-program program (environment-with #"nowhere:99")))
  (define refusal
    (pregexp (format "(?m:^)~a: no window can be opened here\n  reason: [^\n]+\n" who)))
  (values output (regexp-match* refusal output)))

(define (display-server) (find-executable-path "Xvfb"))

;; Xvfb chooses a number that is free and writes it, with a newline, to port 1.
(define (call-with-display use)
  (define folder (make-temporary-file "screen~a" 'directory))
  (define-values (server out in err)
    (parameterize ([current-subprocess-custodian-mode 'kill])
      (subprocess #f #f #f (display-server) "-displayfd" "1" "-fbdir" (path->string folder)
                  "-screen" "0" "800x600x24" "-nolisten" "tcp")))
  (dynamic-wind
   void
   (lambda ()
     (define number (read-line out))
     (when (eof-object? number) (error 'Xvfb "it ended at once: ~a" (port->string err)))
     (define display (string->bytes/utf-8 (string-append ":" number)))
     (parameterize ([current-environment-variables (environment-with display)])
       (putenv "SCREEN_FILE" (path->string (build-path folder "Xvfb_screen0")))
       (use display)))
   (lambda ()
     (subprocess-kill server #t)
     (subprocess-wait server)
     (for-each close-input-port (list out err))
     (close-output-port in)
     (delete-directory/files folder))))

;; The program says the expected lines, all of them and in this order, where there is a
;; display; libraries may complain in between, as they do where there is no home to keep
;; their settings in.
(define (test-windows name program expected . arguments)
  (skip-unless (display-server)
               "Xvfb (Debian: apt install xvfb) is not installed: windows are not opened"
    (define output
      (call-with-display
       (lambda (display) (apply run-program program (environment-with display) arguments))))
    (define (said) (filter (lambda (line) (member line expected)) (string-split output "\n")))
    (skip-unless (not (regexp-match? #rx"ffi-lib: " output))
                 "the shared libraries of racket/gui are not installed: windows are not opened"
      (test-case name (check-equal? (said) expected output)))))
