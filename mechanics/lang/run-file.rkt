#lang racket/base
;; `make run FILE=... ARGS="..."`, which is `racket -l mechanics/lang/run-file FILE ARGS`.
;;
;; Runs a program as `racket FILE` does, with better messages where the file holds no program, or
;; where its parentheses do not match; and it reads a file that begins with a mark of its encoding.

(require "program-file.rkt"
         (only-in "unknown-name/unknown-names.rkt" install-hints!)
         "../error/machine-limits.rkt"
         "../error/note.rkt"
         (only-in "../show/display/program-end.rkt" start-program!))

(provide run-file)

;; name : of a file; arguments : strings, for the program
(define (run-file name arguments)
  (define file (path->complete-path (string->path name)))
  (check-program 'run name file)
  (define without-us (language-without-us file))
  (when without-us (tell-after-errors name without-us))
  (parameterize ([current-command-line-arguments (list->vector arguments)])
    (with-handlers ([exn:fail:read? (lambda (e) (raise-unreadable 'run name e))])
      (if (marked? file) (declare-marked file) (module-declared? file #t)))
    (start-program!)
    (require-submodule file 'configure-runtime)
    (dynamic-require file #f)
    (require-submodule file 'main)))

(define (require-submodule file name)
  (define submodule `(submod ,file ,name))
  (when (module-declared? submodule #t) (dynamic-require submodule #f)))

;; Racket's own loader does not read a program behind the mark.
(define (declare-marked file)
  (define stx (call-with-program file (lambda (port) (read-program file port))))
  (parameterize ([current-module-declare-name (make-resolved-module-path file)])
    (eval (datum->syntax stx (cons (namespace-module-identifier) (cdr (syntax-e stx))) stx stx))))

(define (tell-after-errors name language)
  (define display (error-display-handler))
  (error-display-handler
   (lambda (message e)
     (display message e)
     (note (about-language name language)))))

(module+ main
  (install-hints!)
  (define arguments (vector->list (current-command-line-arguments)))
  (if (or (null? arguments) (string=? (car arguments) ""))
      (raise-unwritable 'run "which file? as in  make run FILE=my-system.rkt")
      (run-file (car arguments) (cdr arguments))))
