#lang racket/base
;; A Run in DrRacket finds the library compiled.
;;
;; Files that are not compiled, or changed since, DrRacket would compile in memory, for minutes at
;; each Run: another process compiles them once and for all, and its lines are shown.

(require compiler/find-exe
         racket/future
         "compiling-note.rkt" "note.rkt" "stale-files.rkt")

(provide prepare-Run)    ; path of a facade -> boolean: is the library compiled now?

(define (prepare-Run facade)
  (define library (simplify-path (build-path facade 'up)))
  (define (compiled?)
    (parameterize ([use-compiled-file-paths (Racket-paths)]) (null? (stale-files library))))
  (unless (compiled?) (compile-library (simplify-path (build-path library 'up))))
  (and (compiled?) (not (for-DrRacket-alone?))))

;; ---------------------------------------------------------------------------

;; home : the folder that holds mechanics/; where it may not be written nothing is done
(define (compile-library home)
  (define program (build-path home ".ci" "compile.rkt"))
  (when (and (file-exists? program) (memq 'write (file-or-directory-permissions home)))
    (note "mechanics is not compiled: this is done now, once, and takes about a minute.")
    (run-showing home program)))

;; Whoever stops the Run stops the process; the next Run goes on where it was.
(define (run-showing home program)
  (define-values (process out in err)
    (parameterize ([current-directory home]
                   [current-environment-variables (environment-with-library home)]
                   [current-subprocess-custodian-mode 'interrupt])
      (subprocess #f #f 'stdout (find-exe) program
                  "--jobs" (number->string (min 4 (processor-count))) "--DrRacket"
                  "--root" "mechanics/main.rkt" "mechanics")))
  (close-output-port in)
  (dynamic-wind
   void
   (lambda () (for ([line (in-lines out)]) (note line)))
   (lambda ()
     (close-input-port out)
     (subprocess-kill process #f))))

;; The library is first among the collections.
(define (environment-with-library home)
  (define variables (environment-variables-copy (current-environment-variables)))
  (define separator (if (eq? (system-type) 'windows) #";" #":"))
  (define others (or (environment-variables-ref variables #"PLTCOLLECTS") #""))
  (environment-variables-set! variables #"PLTCOLLECTS"
                              (bytes-append (path->bytes home) separator others))
  variables)
