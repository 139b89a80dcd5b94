#lang racket/base
;; Isolation of submissions: each runs in a process that can reach nothing.
;;
;; Racket's sandbox contains an honest mistake, and most attacks; but a place that a program
;; starts has no sandbox around it.  So, where Linux has the tools, the process is
;;
;;   prlimit   limited in memory, time, processes, and files, of which it can write none;
;;   unshare   in namespaces of its own: no network, no process but its own, which all end with
;;             the first; its root directory holds Racket and this library, read only;
;;   setpriv   run by nobody, if we are root, and without privileges.
;;
;; A container may give no namespaces, and root's home lets nobody in.  So these levels are tried,
;; the strictest first, until the library loads:
;;
;;   namespaces   all of that;
;;   nobody       prlimit and setpriv, for root alone; a library that only root can read is copied;
;;   own          prlimit: the process belongs to the teacher.

(require compiler/compilation-path
         racket/file
         racket/list
         racket/path
         setup/dirs
         "answer-lines.rkt" "process-cost.rkt"
         "../../error/complain.rkt")

(provide call-with-isolation isolation-levels
         isolation-seconds isolation-megabytes isolation-level isolation-complete?
         level-warning
         start-isolated start-evaluator)

;; megabytes, seconds : that each submission may cost (process-cost.rkt)
;; limits? : does prlimit set limits?  nobody? : does setpriv change the user?
;; level   : of isolation-levels
;; folder  : the mount point of the root directory, or the place of a copied library, or #f
;; idle    : box of an evaluator that waits for a request, as a thunk of its values, or of #f
(struct isolation (megabytes seconds limits? nobody? level folder idle))

(define isolation-levels '(namespaces nobody own))

(define (isolation-complete? i) (eq? 'namespaces (isolation-level i)))

;; The first lines of a report, or #f.
(define (level-warning level)
  (case level
    [(namespaces) #f]
    [(nobody)
     (string-append
      "Submissions were run by the user nobody, in Racket's sandbox, without namespaces of their "
      "own, which this system does not give (see the manual). A sandbox can be escaped from, and "
      "who escapes can read what every user of this system can, reach its network, and disturb "
      "other submissions. Keep worksheets in a folder that only you can read; judge submissions of "
      "people whom you do not trust on a system that gives namespaces.")]
    [(own)
     (string-append
      "Submissions were run in your name, in Racket's sandbox alone, for this system gives them "
      "neither namespaces of their own nor another user (unshare, setpriv, prlimit; see the "
      "manual). A sandbox can be escaped from, and who escapes can read and change what you can. "
      "Do not run submissions of people whom you do not trust here; use a virtual machine with "
      "Linux.")]))

;; Calls `use` with the strictest isolation that works; its folder is deleted and its idle
;; evaluator ended afterwards in any case.  strictest : the first of isolation-levels that is tried
(define (call-with-isolation megabytes seconds use #:strictest [strictest 'namespaces])
  (check-compiled)
  (define evaluators (make-custodian))
  (define folder #f)
  (dynamic-wind
   (lambda () (set! folder (make-folder)))
   (lambda ()
     (use (parameterize ([current-custodian evaluators])
            (find-isolation megabytes seconds folder (memq strictest isolation-levels)))))
   (lambda ()
     (custodian-shutdown-all evaluators)
     (when folder (delete-directory/files folder #:must-exist? #f)))))

;; Each submission would compile the library in memory, for longer than it is given.
(define (check-compiled)
  (define main (build-path (collection-folder) "main.rkt"))
  (unless (for/or ([mode (in-list (use-compiled-file-paths))])
            (file-exists? (get-compilation-bytecode-file main #:modes (list mode) #:roots '(same))))
    (complain 'check (string-append
                      "mechanics is not compiled beside its sources, where submissions load it\n"
                      "  in its checkout: env -u PLTCOMPILEDROOTS make compile"))))

;; -> a folder that everybody may read, or #f where none can be made
(define (make-folder)
  (with-handlers ([exn:fail:filesystem? (lambda (e) #f)])
    (define folder (make-temporary-file "mechanics-class~a" 'directory))
    (file-or-directory-permissions folder #o755)
    folder))

;; The last resort is not tried: a failure there would be one everywhere.
(define (find-isolation megabytes seconds folder allowed)
  (define prlimit? (and (find "prlimit") #t))
  (define setpriv? (and (find "setpriv") #t))
  (define nobody? (and setpriv? (root?)))
  (define (try level nobody? folder)
    (define i (isolation megabytes seconds prlimit? nobody? level folder (box #f)))
    (and (memq level allowed) (works? i) i))
  (or (and folder prlimit? setpriv? (find "unshare")
           (or (and nobody? (try 'namespaces #t folder))
               (try 'namespaces #f folder)))
      (and nobody?
           (or (try 'nobody #t #f)
               (and folder (memq 'nobody allowed) (copy-library folder) (try 'nobody #t folder))))
      (try 'own #f #f)
      (isolation megabytes seconds #f #f 'own #f (box #f))))

(define (find name) (let ([p (find-executable-path name)]) (and p (path->string p))))

(define (root?) (eqv? 0 (owner "/proc/self")))

;; Copies the library for everybody to read, with the times by which compiled files are known to be
;; up to date. -> was there room for it?
(define (copy-library folder)
  (define copy (build-path folder "mechanics"))
  (with-handlers ([exn:fail:filesystem? (lambda (e) #f)])
    (copy-directory/files (collection-folder) copy #:keep-modify-seconds? #t)
    (for ([path (in-sequences (list copy) (in-directory copy))])
      (file-or-directory-permissions path (if (directory-exists? path) #o755 #o644)))
    #t))

;; ---------------------------------------------------------------------------
;; The command

;; Starts Racket with these arguments -> the process, its output, its input, its errors.
;; Its environment says only that compiled files are up to date: none could be written there.
(define (start-isolated i arguments)
  (define command (isolated-command i arguments))
  (parameterize ([current-environment-variables (make-environment-variables
                                                 #"PLT_COMPILED_FILE_CHECK" #"exists")]
                 [current-subprocess-custodian-mode 'kill]
                 [subprocess-group-enabled #t])
    (apply subprocess #f #f #f command)))

;; -> list of strings
(define (isolated-command i arguments)
  (define command (append (list (path->string (racket-program))) (racket-options i) arguments))
  (append (if (isolation-limits? i) (limits i) '())
          (case (isolation-level i)
            [(namespaces) (in-namespaces i (append (setpriv i "--bounding-set=-all"
                                                            "--inh-caps=-all")
                                                   command))]
            [(nobody) (append (setpriv i) command)]
            [else command])))

(define (setpriv i . options)
  (append (list (find "setpriv"))
          (if (isolation-nobody? i)
              (list (format "--reuid=~a" nobody) (format "--regid=~a" nobody) "--clear-groups")
              '())
          options
          (list "--no-new-privs")))

(define nobody 65534)

;; Racket reserves more addresses than it uses.  Its time is watched from outside; this limit,
;; which includes the time of loading, stops a process that is not seen there.
(define (limits i)
  (define bytes (* 1048576 (+ 1024 (* 2 (isolation-megabytes i)))))
  (define seconds (+ 30 (inexact->exact (ceiling (isolation-seconds i)))))
  (list (find "prlimit") (format "--as=~a" bytes) (format "--cpu=~a" seconds)
        (format "--nproc=~a" (+ 128 (tasks-of (user-of i)))) "--nofile=64" "--fsize=0" "--core=0"
        "--"))

;; The system counts all tasks of a user against the limit.
(define (user-of i) (if (isolation-nobody? i) nobody (owner "/proc/self")))

;; Root makes the namespaces itself, and so gives nobody access to a library that only root can
;; read; other users, and root in a container, make them within a namespace of users.
(define (in-namespaces i command)
  (append (list (find "unshare"))
          (if (isolation-nobody? i) '() '("--user" "--map-root-user"))
          '("--mount" "--pid" "--net" "--ipc" "--uts" "--fork" "--kill-child" "--")
          (list "/bin/sh" "-c" set-up "sh" (path->string (isolation-folder i))
                (path->string (collection-folder))
                (number->string (length (needed-folders))))
          (needed-folders)
          command))

;; $1 : folder in which the root directory is made; $2 : the collection of this library, of whose
;; surroundings nothing is seen; $3 : the number of folders that follow; then the command.
;; The system may refuse to bind a folder without the file systems mounted in it; then they come
;; along.  Racket asks /proc for its own name.
(define set-up #<<sh
set -e
umask 022
root=$1; collection=$2; count=$3; shift 3
show() {
  mkdir -p "$2"
  mount --bind "$1" "$2" 2>/dev/null || mount --rbind "$1" "$2"
  mount -o remount,bind,ro "$2"
}
mount -t tmpfs -o size=1m,mode=755 none "$root"
while [ "$count" -gt 0 ]; do
  mkdir -p "$root$(dirname "$1")"
  if [ -L "$1" ]; then ln -s "$(readlink "$1")" "$root$1"
  elif [ -d "$1" ] && [ ! -d "$root$1" ]; then show "$1" "$root$1"
  fi
  shift; count=$((count - 1))
done
show "$collection" "$root/library/mechanics"
mkdir "$root/proc"
mount -t proc -o ro proc "$root/proc"
mount -o remount,bind,ro "$root"
cd /
exec chroot "$root" "$@"
sh
  )

(define (racket-program)
  (define p (find-system-path 'exec-file))
  (simplify-path (path->complete-path (or (find-executable-path p) p)
                                      (find-system-path 'orig-dir))))

;; Collections come from this library and Racket, none from the user's own folder.
(define (racket-options i)
  (list "-A" "/nowhere"
        "-S" (cond [(isolation-complete? i) "/library"]
                   [(isolation-folder i) => path->string]
                   [else (path->string (build-path (collection-folder) 'up))])))

(define (collection-folder) (simple-form-path (collection-path "mechanics")))

;; Shorter paths first, for the longer ones may be within them.
(define (needed-folders)
  (define all
    (map path->string
         (filter values
                 (list* (path-only (racket-program)) (find-collects-dir) (find-config-dir)
                        (find-lib-dir) (find-share-dir)
                        (append (get-main-collects-search-dirs) system-folders)))))
  (sort (remove-duplicates (map without-slash all)) < #:key string-length))

(define system-folders (map string->path '("/usr" "/bin" "/lib" "/lib64" "/sbin")))

(define (without-slash path) (regexp-replace #rx"(.)/$" path "\\1"))

;; ---------------------------------------------------------------------------
;; Does it work?

;; An evaluator is started under all limits, and loads all that a submission loads; the first
;; submission is given to it.
(define (works? i)
  (with-handlers ([exn:fail? (lambda (e) #f)])
    (define-values (process out in err) (start-isolated i evaluator))
    (define ready? (equal? ready-line (peek-bytes (bytes-length ready-line) 0 out)))
    (if ready?
        (set-box! (isolation-idle i) (lambda () (values process out in err)))
        (subprocess-kill process #t))
    ready?))

(define evaluator '("-l" "racket/base" "-l" "mechanics/lang/command/evaluate-submission"))

;; Starts a process that evaluates one submission, or gives the idle one; results as of
;; start-isolated.
(define (start-evaluator i)
  (define idle (unbox (isolation-idle i)))
  (if (and idle (box-cas! (isolation-idle i) idle #f))
      (idle)
      (start-isolated i evaluator)))
