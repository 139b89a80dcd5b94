#lang racket/base
;; The note on a library that is not compiled, its occasions, and where it is heard first.

(require compiler/find-exe
         mechanics/error/DrRacket-run
         mechanics/error/compiling-note
         racket/file
         (only-in racket/format ~a)
         racket/list
         racket/port
         racket/runtime-path
         racket/string
         racket/system
         mechanics/error/stale-files
         "../support/checks.rkt"
         "../support/house/library.rkt" "../support/run-text.rkt" "../support/skip.rkt")

(define-runtime-path room "../../../mechanics/error")
(define-runtime-path compilers "../../../.ci")

;; more : names of other files of the room
(define (call-in-copy f . more)
  (define folder (make-temporary-file "mechanics copy ~a" 'directory))
  (define copy (build-path folder "mechanics" "error"))
  (dynamic-wind
   (lambda () (make-directory* copy))
   (lambda ()
     (for ([name (append '("uncompiled.rkt" "compiling-note.rkt" "note.rkt") more)])
       (copy-file (build-path room name) (build-path copy name)))
     (f (path->string (path->directory-path folder)) (build-path copy "uncompiled.rkt")))
   (lambda () (delete-directory/files folder))))

;; -> what a Racket prints that is started so
(define (racket . arguments)
  (define out (open-output-string))
  (parameterize ([current-output-port out] [current-error-port out])
    (apply system* (find-exe) arguments))
  (get-output-string out))

;; -> path of a facade in the copy, which requires the files of that name after it has told
(define (write-facade folder name . required)
  (define file (build-path folder "mechanics" name))
  (with-output-to-file file #:exists 'truncate
    (lambda ()
      (printf "#lang racket/base\n(require \"error/uncompiled.rkt\")\n(tell-if-uncompiled)\n")
      (for ([name required]) (printf "(require ~s)\n" name))))
  file)

;; Text printed where the file is expanded, as for colours, and not declared
(define (expanded-alone folder file)
  (racket "-e" (format "(parameterize ([read-accept-reader #t] [current-load-relative-directory ~s])
                          (void (expand (call-with-input-file ~s read-syntax))))"
                       (string-append folder "mechanics/") (path->string file))))

(define (compile-to-file file)
  (check-equal? (racket "-N" "raco" "-l-" "raco" "make" (path->string file)) ""))

(skip-unless (eq? (system-type) 'unix) "the advice is Unix's"
  (test-case "a facade in memory tells, once for all that it loads; a compiled one does not"
    (call-in-copy
     (lambda (folder file)
       (define advice
         (lines
          "; mechanics is not compiled: each start takes half a minute, in DrRacket minutes."
          (format "; Once and for all:  make -C '~a' compile" folder)))
       (define base (write-facade folder "base.rkt"))
       (define main (write-facade folder "main.rkt" "base.rkt"))
       (check-equal? (racket main) advice)
       (for ([compiled (list file base)])     ; a compilation that is broken off goes as far
         (compile-to-file compiled)
         (check-equal? (racket main) advice))
       (check-equal? (racket base) "")
       (check-equal? (expanded-alone folder main) "")
       (compile-to-file main)
       (check-equal? (racket main) ""))))

  (test-case "where DrRacket compiles for itself other words tell what to do"
    (check-equal? (parameterize ([use-compiled-file-paths
                                  (list (build-path "compiled" "drracket" "errortrace")
                                        (string->path "compiled"))])
                    (uncompiled-text "/sicm/"))
                  "The first Run takes some minutes: DrRacket compiles mechanics with debugging.
Programs outside of /sicm/ need not wait, once mechanics is installed:  make -C '/sicm/' install"))

  (test-case "what has changed since it was compiled is told with its name and number"
    (define (said files)
      (define out (open-output-string))
      (parameterize ([current-error-port out]) (tell-of-stale files "/sicm/"))
      (get-output-string out))
    (check-equal? (said '("a.rkt"))
                  (lines
                   "; mechanics is not compiled as it is now: a.rkt changed since, which may lead to strange errors."
                   "; To mend it:  make -C '/sicm/' compile"))
    (check-regexp-match #rx": a.rkt and another file changed since," (said '("a.rkt" "b.rkt")))
    (check-equal? (said '("a.rkt" "b.rkt" "c.rkt"))
                  (lines
                   "; mechanics is not compiled as it is now: a.rkt and 2 other files changed since, which may lead to strange errors."
                   "; To mend it:  make -C '/sicm/' compile"))))

(test-case "nobody reads what goes to a file or nowhere in DrRacket"
  (check-false (unread? (open-output-string)))
  (check-true (unread? (open-output-nowhere)))
  (define file (make-temporary-file))
  (call-with-output-file file #:exists 'truncate (lambda (port) (check-true (unread? port))))
  (delete-file file))

(test-case "files are stale until they are compiled, and when they change"
  (call-in-copy
   (lambda (folder file)
     (define (stale) (map (lambda (p) (last (explode-path p))) (stale-files folder)))
     (define all (map string->path '("compiling-note.rkt" "note.rkt" "uncompiled.rkt")))
     (check-equal? (stale) all)
     (racket "-N" "raco" "-l-" "raco" "make" (path->string file))
     (check-equal? (stale) '())
     (define in-DrRacket (list (build-path "compiled" "drracket") (string->path "compiled")))
     (check-equal? (parameterize ([use-compiled-file-paths in-DrRacket]) (stale)) '())
     (define-values (room name _) (split-path file))
     (define compiled
       (file-or-directory-modify-seconds (build-path room "compiled" "uncompiled_rkt.zo")))
     (file-or-directory-modify-seconds file compiled)
     (check-equal? (stale) '())
     (file-or-directory-modify-seconds file (+ 100 (current-seconds)))
     (check-equal? (stale) (list (last all)))
     (check-equal? (parameterize ([use-compiled-file-paths in-DrRacket]) (stale))
                   (list (last all))))))

(test-case "who reads a program is told of stale files; not who compiles one, or asks for no check"
  (call-in-copy
   (lambda (folder file)
     (define (in-folder name) (build-path folder "mechanics" "error" name))
     (define reading (build-path folder "reading.rkt"))
     (display-to-file
      (string-append "#lang racket/base\n"
                     "(require (for-syntax racket/base mechanics/error/stale-files))\n"
                     "(begin-for-syntax (tell-of-stale-files))\n")
      reading)
     (define variables (environment-variables-copy (current-environment-variables)))
     (environment-variables-set! variables #"PLTCOLLECTS" (string->bytes/utf-8 (~a folder ":")))
     (define (said . arguments)
       (parameterize ([current-environment-variables variables]) (apply racket arguments)))
     (define (compiled name) (said "-N" "raco" "-l-" "raco" "make" (path->string name)))
     (check-equal? (map compiled (list file (in-folder "stale-files.rkt"))) '("" ""))
     (check-equal? (said reading) "")
     (define newer (in-folder "newer.rkt"))
     (display-to-file "#lang racket/base\n" newer)
     (check-regexp-match #rx"^; mechanics is not compiled as it is now: .*newer.rkt changed since"
                         (said reading))
     (environment-variables-set! variables #"PLT_COMPILED_FILE_CHECK" #"exists")
     (check-equal? (said reading) "")
     (environment-variables-set! variables #"PLT_COMPILED_FILE_CHECK" #f)
     (check-equal? (compiled reading) ""))
   "stale-files.rkt"))

(test-case "both languages tell of stale files when they are read"
  (for ([reader '(mechanics/lang/reader (submod mechanics/worksheet reader))])
    (dynamic-require reader (void))
    (check-regexp-match #rx"stale-files" (format "~s" (module->imports reader)))))

(test-case "a Run in DrRacket has the library compiled once, and shows how far that is"
  (call-in-copy
   (lambda (folder file)
     (define main (write-facade folder "main.rkt" "error/note.rkt"))
     (define (prepared)
       (define out (open-output-string))
       (parameterize ([current-error-port out]) (check-true (prepare-Run main)))
       (get-output-string out))
     (make-directory (build-path folder ".ci"))
     (for ([name '("compile.rkt" "DrRacket-files.rkt")])
       (copy-file (build-path compilers name) (build-path folder ".ci" name)))
     (check-regexp-match
      (string-append "^; mechanics is not compiled: this is done now, once, "
                     "and takes about a minute.\n"
                     "; Compiling 4 files of mechanics ...\n")
      (prepared))
     (check-equal? (prepared) "")
     (check-equal? (racket main) ""))))

(test-case "what compiles for a Run finds the library before the other collections"
  (call-in-copy
   (lambda (folder file)
     (define main (write-facade folder "main.rkt"))
     (define variables (environment-variables-copy (current-environment-variables)))
     (environment-variables-set! variables #"PLTCOLLECTS" #"/other:")
     (make-directory (build-path folder ".ci"))
     (display-to-file "#lang racket/base\n(display (getenv \"PLTCOLLECTS\"))\n"
                      (build-path folder ".ci" "compile.rkt"))
     (define out (open-output-string))
     (parameterize ([current-error-port out] [current-environment-variables variables])
       (check-false (prepare-Run main)))
     (check-equal? (last (string-split (get-output-string out) "\n"))
                   (format "; ~a:/other:" folder)))))

(test-case "where it cannot be compiled a Run is told so"
  (call-in-copy
   (lambda (folder file) (check-false (prepare-Run (write-facade folder "main.rkt"))))))

;; ---------------------------------------------------------------------------
;; Who requires a facade is told before anything else of the library is compiled

;; The forms that a facade begins with
(define tells "\n(require \"error/uncompiled.rkt\")\n(tell-if-uncompiled)\n")

(test-case "every facade tells before it requires anything else"
  (for ([facade (in-list (filter facade? (library-files)))])
    (define start (regexp-match-positions #rx"\n[(]" (file-text facade)))
    (check-equal? (substring (file-text facade) (caar start) (+ (caar start) (string-length tells)))
                  tells facade)))
