#lang racket/base
;; `raco mechanics jupyter`: makes the kernel known to a Jupyter that is there, or forgets it.
;;
;; A kernel is a folder with a file kernel.json, which says how it is started: Python runs the
;; folder of this library that has the kernel's package, which finds this Racket and this library.

(require json
         compiler/find-exe
         racket/cmdline
         racket/file
         racket/runtime-path
         (only-in racket/string string-trim)
         racket/system
         "../../error/complain.rkt")

(provide jupyter-command)

(define-runtime-path package-folder "../../notebook/python")

;; arguments : strings -> 0
(define (jupyter-command arguments)
  (define-values (python prefix remove?) (values #f #f #f))
  (command-line
   #:program "raco mechanics jupyter"
   #:argv arguments
   #:once-each
   [("--python") file "the Python that Jupyter runs in (python3)" (set! python file)]
   [("--prefix") folder "a Python environment to install into, in place of your own folder"
                 (set! prefix folder)]
   [("--remove") "take the kernel away again" (set! remove? #t)]
   #:args ()
   (define folder (kernel-folder prefix))
   (if remove? (remove-kernel folder) (install-kernel folder (python-with-Jupyter python))))
  0)

(define (install-kernel folder python)
  (make-directory* folder)
  (call-with-output-file (build-path folder "kernel.json") #:exists 'truncate
    (lambda (out) (write-json (specification python) out)))
  (printf "the kernel mechanics is in ~a\n" folder)
  (printf "Jupyter offers it for new notebooks; --remove takes it away\n"))

(define (remove-kernel folder)
  (cond [(directory-exists? folder)
         (delete-directory/files folder)
         (printf "the kernel mechanics was taken out of ~a\n" folder)]
        [else (printf "there is no kernel mechanics in ~a\n" folder)]))

(define (specification python)
  (define collections (getenv "PLTCOLLECTS"))
  (define environment
    (hasheq 'MECHANICS_RACKET (path->string (find-exe))))
  (define folder (path->string (simplify-path package-folder)))
  (hasheq 'argv (list python folder "-f" "{connection_file}")
          'display_name "mechanics"
          'language "racket"
          'interrupt_mode "message"
          'env (if collections (hash-set environment 'PLTCOLLECTS collections) environment)))

;; ---------------------------------------------------------------------------

;; Where Jupyter looks: in a Python environment, or in the user's own folder.
(define (kernel-folder prefix)
  (define data
    (cond [prefix (build-path (path->complete-path prefix) "share" "jupyter")]
          [(getenv "JUPYTER_DATA_DIR") => values]
          [else (user-data)]))
  (build-path data "kernels" "mechanics"))

(define (user-data)
  (define home (find-system-path 'home-dir))
  (case (system-type)
    [(macosx) (build-path home "Library" "Jupyter")]
    [(windows) (build-path (or (getenv "APPDATA") home) "jupyter")]
    [else (build-path (or (getenv "XDG_DATA_HOME") (build-path home ".local" "share"))
                      "jupyter")]))

;; given : as on the command line, or #f -> its full path; an error names the lack
(define (python-with-Jupyter given)
  (define python (find-executable-path (or given "python3")))
  (unless python
    (complain 'jupyter "there is no ~a; --python names the Python that Jupyter runs in"
              (or given "python3")))
  (define-values (there? words) (run-python python "import ipykernel, psutil, ipywidgets"))
  (unless there?
    (complain 'jupyter "Python lacks what a kernel needs: ~a\n  ~a -m pip install -r ~a"
              (last-line words) python
              (simplify-path (build-path package-folder "requirements.txt"))))
  (path->string python))

;; -> did it succeed?  and its output
(define (run-python python statement)
  (define out (open-output-string))
  (define there?
    (parameterize ([current-output-port out] [current-error-port out])
      (system* python "-c" statement)))
  (values there? (string-trim (get-output-string out) #:left? #f)))

(define (last-line text) (car (regexp-match #px"[^\n]*$" text)))
