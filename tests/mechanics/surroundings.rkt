#lang racket/base
;; Messages of make's commands where something around the checkout is missing: programs on
;; the path are played by scripts, and requests to the network fail.

(require racket/file
         racket/port
         racket/runtime-path
         racket/string
         "support/checks.rkt" "support/folder.rkt"
         (file "../../.ci/compile.rkt")
         "support/skip.rkt")

(define-runtime-path script "../../.ci/ensure-racket.sh")

;; Programs that the script itself uses.
(define tools '("sh" "awk" "cat" "cut" "env" "grep" "head" "mktemp" "rm" "sed" "tr"))

;; programs : ((name line ...) ...), shell scripts; settings : ((name . value) ...)
;; -> exit code, what was said
(define (ensure programs #:settings [settings '()])
  (with-folder (folder)
    (for ([tool (in-list tools)])
      (make-file-or-directory-link (find-executable-path tool) (build-path folder tool)))
    (for ([program (in-list programs)]) (make-script folder (car program) (cdr program)))
    (run-in folder settings)))

(define (make-script folder name lines)
  (define file (build-path folder name))
  (display-lines-to-file (cons "#!/bin/sh" lines) file)
  (file-or-directory-permissions file #o755))

(define (run-in folder settings)
  (define environment (make-environment-variables #"PATH" (path->bytes folder)))
  (define (put name value)
    (environment-variables-set! environment
                                (string->bytes/utf-8 name) (string->bytes/utf-8 value)))
  (for ([setting (in-list settings)]) (put (car setting) (cdr setting)))
  (define-values (process out in err)
    (parameterize ([current-environment-variables environment])
      (subprocess #f #f 'stdout (find-executable-path "sh") script)))
  (close-output-port in)
  (define said (string-replace (port->string out) (path->string folder) "/bin"))
  (close-input-port out)
  (subprocess-wait process)
  (values (subprocess-status process) said))

;; The script ends with 1, and these are its first lines.
(define-check (check-says programs settings lines)
  (define-values (code said) (ensure programs #:settings settings))
  (define first-lines
    (for/list ([line (in-list (string-split said "\n"))] [_ (in-list lines)]) line))
  (with-check-info (['said said] ['code code])
    (unless (and (eqv? code 1) (equal? first-lines lines)) (fail-check))))

(define (racket version . lines)
  (list* "racket"
         "if [ \"$1\" = --version ]; then"
         (format "echo 'Welcome to Racket v~a [cs].'; exit 0; fi" version)
         lines))

(define (user id) `("id" ,(format "echo ~a" id)))

(skip-unless (eq? (system-type) 'unix) "the script is for Unix"
  (test-case "a Racket that is there, new enough and whole is no matter of words"
    (define-values (code said) (ensure (list (racket "8.10" "exit 0"))))
    (check-equal? (list code said) '(0 "")))

  (test-case "a Racket that is too old"
    (check-says (list (racket "7.2")) '()
                '("/bin/racket is Racket 7.2, which is too old."
                  "" "mechanics needs Racket 8.7 or later.  Ways to get it:")))

  (test-case "minimal Racket"
    (check-says (list (racket "8.7" "exit 1")) '()
                '("/bin/racket is Racket 8.7 without the main distribution; this adds it:"
                  "  raco pkg install --auto main-distribution")))

  (test-case "a Racket that does not start with the environment as it is"
    (check-says '(("racket" "echo 'collection-links: contract violation' >&2"))
                '(("PLTUSERHOME" . "home") ("PLTADDONDIR" . "addons"))
                '("/bin/racket does not start:"
                  "  collection-links: contract violation"
                  "The environment sets PLTUSERHOME PLTADDONDIR for it; folders there are full paths.  Without them:"
                  "  env -u PLTUSERHOME -u PLTADDONDIR make ...")))

  (test-case "a Racket that does not start by itself"
    (check-says '(("racket" "echo 'racket: no petite.boot' >&2; exit 1")) '()
                '("/bin/racket does not start:" "  racket: no petite.boot"
                  "Install it again, and run the same make command.")))

  (test-case "a Racket that is named and not there is not replaced by another"
    (check-says `(("apt-get") ,(user 0)) '(("RACKET" . "/opt/no-such-racket"))
                '("There is no /opt/no-such-racket, which RACKET names.")))

  (test-case "no Racket, and nothing to install it with"
    (check-says '() '() '("There is no Racket here, and no apt-get to install it with.")))

  (test-case "no Racket, and nobody who may install it"
    (check-says `(("apt-get") ,(user 1000)) '()
                '("There is no Racket here, and installing it takes root or sudo: as root, run"
                  "  apt-get update && apt-get install racket")))

  (test-case "no network, on a machine that has never had one"
    (check-says `(("apt-get" "exit 100") ("apt-cache") ,(user 0)) '()
                '("Installing Racket (package racket, about 100 MB) ..."
                  "(apt-get update reported errors: no network? going on)"
                  "apt-get knows no package racket; without a network it cannot ask.")))

  (test-case "no network any more"
    (check-says `(("apt-get" "echo 'E: Failed to fetch racket.deb'; exit 100")
                  ("apt-cache" "echo '  Candidate: 8.10+dfsg1-2'") ,(user 0))
                '()
                '("Installing Racket (package racket, about 100 MB) ..."
                  "E: Failed to fetch racket.deb"
                  "(apt-get update reported errors: no network? going on)"
                  "E: Failed to fetch racket.deb"
                  "apt-get could not install Racket; above is what it says.")))

  (test-case "a system whose Racket is too old"
    (check-says `(("apt-get") ("apt-cache" "echo '  Candidate: 7.9+dfsg1-2'") ,(user 0)) '()
                '("Installing Racket (package racket, about 100 MB) ..."
                  "The package racket of this system is version 7.9+dfsg1-2, which is too old."))))

;; ---------------------------------------------------------------------------
;; Compiling

(test-case "a full disk and a folder that may only be read are told with what to do"
  (check-equal? (write-error-advice "writing\n  system error: No space left on device; errno=28")
                "The disk is full: what is compiled needs some 60 MB there.
  Make room, and run the same command again.")
  (check-equal? (read-only-advice "/checkout/")
                "/checkout/ may not be written by you, and what is compiled goes there.
  Its owner can run  make compile ; or do it in a copy of the checkout that is yours.")
  (check-false (write-error-advice "x: unbound identifier")))

;; Root may write everywhere; whether we may is tried.
(define (can-write-in? folder)
  (with-handlers ([exn:fail:filesystem? (lambda (_) #f)])
    (make-directory (build-path folder "tried"))
    (delete-directory (build-path folder "tried"))
    #t))

(test-case "a folder that is not there yet is as the one above; what can be written is not blamed"
  (define folder (path->directory-path (make-temporary-file "mechanics-folder-~a" 'directory)))
  (define (denied file)
    (write-error-advice
     (format "open: cannot open\n  path: ~a\n  system error: Permission denied; errno=13" file)))
  (check-false (unwritable-part (build-path folder "a" "b")))
  (check-false (denied (build-path folder "secret.rkt")))
  (file-or-directory-permissions folder #o500)
  (define expected (and (not (can-write-in? folder)) folder))
  (define part (unwritable-part (build-path folder "a" "b")))
  (check-equal? (and part (path->directory-path part)) expected)
  (check-equal? (denied (build-path folder "b.rkt")) (and expected (read-only-advice expected)))
  (delete-directory folder))
