#lang racket/base
;; Makes this checkout a package of the Racket that runs this, with its manual:
;;
;;     racket install.rkt [--no-docs]        make install, make install DOCS=no
;;     racket install.rkt --remove           make uninstall
;;
;; The work is `raco pkg`'s; this says what is done, how long it takes and what to do when it
;; fails.  The library is compiled before, by make.

(require compiler/find-exe
         db/sqlite3
         pkg/lib
         racket/cmdline
         racket/list
         racket/path
         racket/runtime-path
         racket/string
         (only-in setup/dirs find-pkgs-dir)
         (only-in "DrRacket-files.rkt" link-for-DrRacket)
         (only-in "compile.rkt" unwritable-part))

(define-runtime-path here "install.rkt")
(define (full-name folder) (path->directory-path (simple-form-path folder)))
(define checkout (full-name (build-path here 'up 'up)))
(define name "mechanics")

(define (say text . parts)
  (displayln (apply format text parts))
  (flush-output))

;; ---------------------------------------------------------------------------
;; State of the installation

;; The scope of the installed package, else Racket's default: 'user, 'installation or a folder
(define (scope)
  (with-pkg-lock/read-only (or (find-pkg-installation-scope name) (default-pkg-scope))))

(define (scope-arguments)
  (define s (scope))
  (if (symbol? s) (list "--scope" (symbol->string s)) (list "--scope-dir" (path->string s))))

;; -> folder of the package, or #f
(define (installed-in)
  (define folder (pkg-directory name))
  (and folder (full-name folder)))

;; Whose ever the packages are, their folder may not be the reader's to write.
(define (check-packages-folder)
  (define user? (eq? (scope) 'user))
  (define part (unwritable-part (if user? (find-system-path 'addon-dir) (find-pkgs-dir))))
  (when part
    (raise-user-error
     (format "~a may not be written by you, and Racket keeps ~a packages there.\n  ~a" part
             (if user? "your" "its")
             (if user?
                 "Give it a folder of yours, now and whenever you use it:  PLTADDONDIR=... make install"
                 "For you alone:  raco pkg config --set default-scope user  and make install again.")))))

;; ---------------------------------------------------------------------------
;; Installing

;; since : seconds when whoever wants it began to wait
(define (install manual? since)
  (check-packages-folder)
  (define before (installed-in))
  (say (cond [(not before) "Installing mechanics in Racket ~a (~a), from ~a ..."]
             [(equal? before checkout)
              "mechanics is installed in Racket ~a (~a) from ~a; bringing it up to date ..."]
             [else "mechanics was installed in Racket ~a (~a); from now on it is ~a ..."])
       (version) (find-exe) checkout)
  (link-for-DrRacket (build-path checkout "mechanics"))
  (define with-manual? (and manual? (can-make-manual?)))
  (when with-manual?
    (say "The manual takes some three minutes; make install DOCS=no does without."))
  (raco-pkg (append (if before '("update") '("install"))
                    '("--link" "--deps" "search-auto" "--name") (list name)
                    (scope-arguments)
                    (if with-manual? '() '("--no-docs"))
                    (list (path->string checkout))))
  (say "mechanics is installed, after ~a s: #lang mechanics in DrRacket, racket -I mechanics at a \
terminal~a."
       (- (current-seconds) since)
       (if with-manual? ", raco docs mechanics for the manual" "")))

;; Racket's index of all manuals is a data base.
(define (can-make-manual?)
  (define can? (sqlite3-available?))
  (unless can?
    (say "The manual is left out, for want of SQLite (Debian: apt-get install libsqlite3-0).~a"
         "\nOnce that is there, make install adds it; make docs makes it in build/doc without."))
  can?)

(define (remove-package)
  (cond [(installed-in)
         (say "Removing mechanics from Racket ~a (~a); the checkout stays ..." (version) (find-exe))
         (raco-pkg (append '("remove") (scope-arguments) (list name)))
         (say "mechanics is removed.")]
        [else (say "mechanics is not installed in Racket ~a (~a)." (version) (find-exe))]))

;; ---------------------------------------------------------------------------
;; raco pkg

(define (raco-pkg arguments)
  (define-values (process out in err)
    (apply subprocess #f #f 'stdout (find-exe) "-N" "raco" "-l-" "raco" "pkg" arguments))
  (close-output-port in)
  (define lines (for/list ([line (in-lines out)]) (show-step line) line))
  (subprocess-wait process)
  (unless (zero? (subprocess-status process))
    (raise-user-error
     (format "raco pkg ~a failed; its last words:\n  ~a"
             (string-join arguments)
             (string-join (take-right lines (min 12 (length lines))) "\n  ")))))

;; `raco setup: --- building documentation ---     [12:00:00]` among its lines says where it is.
(define (show-step line)
  (define step (regexp-match #rx"^raco setup: --- ((compiling|building) .*) ---" line))
  (when step (say "  ~a ..." (cadr step))))

(module+ main
  (define manual? #t)
  (define remove? #f)
  (define since (current-seconds))
  (command-line
   #:once-each
   ["--since" seconds "count the time from <seconds> on" (set! since (string->number seconds))]
   #:once-any
   ["--no-docs" "leave the manual out" (set! manual? #f)]
   ["--remove" "remove the package" (set! remove? #t)])
  (if remove? (remove-package) (install manual? since)))
