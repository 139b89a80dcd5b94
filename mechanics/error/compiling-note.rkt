#lang racket/base
;; The notes that a library prints when it is not compiled, or has changed since it was.

(require "note.rkt")

(provide tell-of-compiling    ; path of a facade ->
         tell-of-stale        ; paths of files in mechanics/, the folder that holds it ->
         nobody-waits?        ; -> boolean: is the program compiled to a file, or only looked at?
         uncompiled-text      ; folder that holds mechanics/ -> string
         unread?              ; port -> boolean
         for-DrRacket-alone?  ; -> boolean: does DrRacket compile for itself?
         Racket-paths)        ; -> folders of compiled files but DrRacket's own

;; `raco make` and `raco setup` report their own progress.  A module that is expanded and not
;; declared is loaded by nobody, and nobody waits.
(define (tell-of-compiling facade)
  (define text (uncompiled-text (simplify-path (build-path facade 'up 'up))))
  (cond [(not (current-module-declare-name)) (void)]
        [(and (not in-DrRacket?) (compiled-to-file?)) (void)]
        [(and in-DrRacket? (unread? (current-error-port)))
         (raise (exn:fail:unsupported text (current-continuation-marks)))]
        [(and in-DrRacket? (prepared? facade)) (void)]
        [(first-in-namespace?) (note text)]))

;; Loaded in DrRacket alone.
(define (prepared? facade)
  ((dynamic-require (build-path facade 'up "error" "DrRacket-run.rkt") 'prepare-Run) facade))

;; A facade in memory may load others, each of which would tell.  Each module is expanded with
;; instances of its own, so variables cannot keep that the note was written: a module declared in
;; the reader's namespace does.
(define (first-in-namespace?)
  (define told (string->unreadable-symbol "mechanics is not compiled"))
  (define (declare)
    (define module
      (parameterize ([current-namespace (make-base-namespace)])
        (compile `(module ,told '#%kernel))))
    (parameterize ([current-module-declare-name (make-resolved-module-path told)])
      (eval module))
    #t)
  (and (not (module-declared? `(quote ,told) #f)) (declare)))

(define (tell-of-stale files folder) (note (stale-text files folder)))

(define (nobody-waits?)
  (or (compiled-to-file?) (and in-DrRacket? (unread? (current-error-port)))))

;; The compilation manager listens to this topic for the dependencies of a file; who listens to all
;; topics is somebody else.
(define (compiled-to-file?)
  (define (heard? topic) (log-level? (current-logger) 'info topic))
  (and (heard? 'cm-accomplice) (not (heard? 'mechanics-unheard))))

(define in-DrRacket?
  (regexp-match? #rx"(?i:drracket)" (path->string (find-system-path 'run-file))))

;; DrRacket looks at a program as soon as it is in a window, to colour and to expand it; text
;; printed then nobody sees, and the window would wait.  An error ends that, and leaves the
;; work to Run.
(define (unread? port)
  (or (file-stream-port? port) (eq? (object-name port) 'nowhere)))

;; ---------------------------------------------------------------------------
;; The words

(define (uncompiled-text folder)
  (if (for-DrRacket-alone?)
      (format "The first Run takes some minutes: DrRacket compiles mechanics with debugging.\n\
Programs outside of ~a need not wait, once mechanics is installed:  ~a"
              folder (command folder "install"))
      (format "mechanics is not compiled: each start takes half a minute, in DrRacket minutes.\n\
Once and for all:  ~a"
              (command folder "compile"))))

;; DrRacket compiles with debugging a package one of whose files is open.
(define (for-DrRacket-alone?) (ormap for-DrRacket? (use-compiled-file-paths)))

(define (for-DrRacket? path)
  (regexp-match? #rx"drracket" (if (path? path) (path->string path) path)))

(define (Racket-paths)
  (for/list ([path (in-list (use-compiled-file-paths))] #:unless (for-DrRacket? path)) path))

(define (stale-text files folder)
  (format "mechanics is not compiled as it is now: ~a~a changed since, which may lead to strange \
errors.\nTo mend it:  ~a"
          (car files)
          (case (length (cdr files))
            [(0) ""]
            [(1) " and another file"]
            [else (format " and ~a other files" (length (cdr files)))])
          (command folder "compile")))

(define (command folder target)
  (if (eq? (system-type) 'windows)
      "raco setup --no-docs mechanics"
      (format "make -C '~a' ~a" folder target)))
