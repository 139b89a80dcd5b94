#lang racket/base
;; Where submissions run: in a process that can reach nothing.
;;
;; A sandbox of Racket's keeps an honest mistake in, and most attacks; but a place that a program
;; starts has no sandbox around it.  So, where Linux has the tools, the process is
;;
;;   prlimit   limited in memory, time, processes, and files, of which it can write none;
;;   setpriv   run by nobody, if we are root;
;;   unshare   in namespaces of its own: no network, no process but its own, which all end with
;;             the first; its root directory holds Racket and this library, read only.
;;
;; Whether they work is tried.  Where they do not, the report says so.

(require racket/file
         racket/list
         racket/path
         racket/port
         setup/dirs
         "tasks.rkt")

(provide find-isolation close-isolation
         isolation-seconds isolation-megabytes isolation-complete? isolation-warning
         start-isolated)

;; limits, person, spaces : lists of strings that stand before a command, each perhaps empty
;; folder  : where the root directory of the process is put together, or #f
(struct isolation (megabytes seconds limits? person spaces folder))

(define (isolation-complete? i) (and (isolation-folder i) #t))

;; What is to be told on top of a report, or #f.
(define (isolation-warning i)
  (and (not (isolation-complete? i))
       (string-append
        "Submissions were run in Racket's sandbox alone, for this system gives them no namespaces "
        "of their own (unshare, setpriv, prlimit; see the manual). A sandbox can be escaped from: "
        "do not run submissions of people whom you do not trust here.")))

;; megabytes, seconds : of each submission, what it may cost (cost.rkt).  namespaces? : #f
;; leaves them out
(define (find-isolation megabytes seconds #:namespaces? [namespaces? #t])
  (define person
    (if (and (find "setpriv") (root?))
        (list (find "setpriv") (format "--reuid=~a" nobody) (format "--regid=~a" nobody)
              "--clear-groups" "--no-new-privs")
        '()))
  (define limited (isolation megabytes seconds (and (find "prlimit") #t) person '() #f))
  (define full (and namespaces? (find "prlimit") (find "unshare") (find "setpriv")
                    (with-namespaces limited)))
  (cond [(and full (works? full)) full]
        [else (when full (close-isolation full))
              limited]))

(define nobody 65534)

(define (find name) (let ([p (find-executable-path name)]) (and p (path->string p))))

(define (root?)
  (define id (find "id"))
  (and id (equal? "0\n" (output-of (lambda () (subprocess #f #f #f id "-u"))))))

(define (with-namespaces i)
  (define folder (make-temporary-file "mechanics-class~a" 'directory))
  (file-or-directory-permissions folder #o755)
  (struct-copy isolation i
               [spaces (list (find "unshare") "--user" "--map-root-user" "--mount" "--pid" "--net"
                             "--ipc" "--uts" "--fork" "--kill-child" "--")]
               [folder folder]))

(define (close-isolation i)
  (when (isolation-folder i)
    (delete-directory/files (isolation-folder i) #:must-exist? #f)))

;; ---------------------------------------------------------------------------
;; The command

;; Starts Racket with these arguments -> the process, its output, its input, its errors.
;; Its environment is empty, but that compiled files are to be taken as they are: there none
;; could be written.
(define (start-isolated i arguments)
  (define command (isolated-command i arguments))
  (parameterize ([current-environment-variables (make-environment-variables
                                                 #"PLT_COMPILED_FILE_CHECK" #"exists")]
                 [current-subprocess-custodian-mode 'kill]
                 [subprocess-group-enabled #t])
    (apply subprocess #f #f #f command)))

;; All that it needs being readable. -> list of strings
(define (isolated-command i arguments)
  (append (if (isolation-limits? i) (limits i) '())
          (isolation-person i)
          (in-namespaces i (append (list (path->string (racket-program))) (racket-options i)
                                   arguments))))

;; Racket reserves more addresses than it uses.  Its time is watched over from outside; this
;; limit, which counts that of loading as well, is for what would not be seen there.
(define (limits i)
  (define bytes (* 1048576 (+ 1024 (* 2 (isolation-megabytes i)))))
  (define seconds (+ 30 (inexact->exact (ceiling (isolation-seconds i)))))
  (list (find "prlimit") (format "--as=~a" bytes) (format "--cpu=~a" seconds)
        (format "--nproc=~a" (+ 128 (tasks-of (user-of i)))) "--nofile=64" "--fsize=0" "--core=0"
        "--"))

;; The system counts all tasks of a user against the limit, whoever started them.
(define (user-of i) (if (null? (isolation-person i)) (owner "/proc/self") nobody))

(define (in-namespaces i command)
  (if (isolation-folder i)
      (append (isolation-spaces i)
              (list "/bin/sh" "-c" set-up "sh" (path->string (isolation-folder i))
                    (path->string (collection-folder))
                    (number->string (length (needed-folders))))
              (needed-folders)
              command)
      command))

;; $1 : where to put the root directory together; $2 : the collection of this library, of which
;; nothing around it is seen; $3 : how many folders follow that it needs; then the command.
;; The system may refuse a folder without what is mounted in it; then that comes along.  Racket
;; asks /proc for its own name.  Capabilities, which only hold in the namespaces anyway, are
;; given up.
(define set-up #<<sh
set -e
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
mount -t proc proc "$root/proc"
mount -o remount,bind,ro "$root"
cd /
exec chroot "$root" /usr/bin/setpriv --bounding-set=-all --inh-caps=-all --no-new-privs "$@"
sh
  )

(define (racket-program)
  (define p (find-system-path 'exec-file))
  (simplify-path (path->complete-path (or (find-executable-path p) p)
                                      (find-system-path 'orig-dir))))

;; Where the collection of this library is found; nothing of the user's own.
(define (racket-options i)
  (list "-A" "/nowhere" "-S" (if (isolation-folder i)
                                 "/library"
                                 (path->string (build-path (collection-folder) 'up)))))

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

(define (works? i)
  (define arguments '("-l" "racket/base" "-e" "(display 'here)"))
  (equal? "here" (output-of (lambda () (start-isolated i arguments)))))

;; What a process writes; "" if it cannot be started.
(define (output-of start)
  (with-handlers ([exn:fail? (lambda (e) "")])
    (define-values (process out in err) (start))
    (close-output-port in)
    (define text (port->string out))
    (close-input-port out)
    (close-input-port err)
    (subprocess-wait process)
    text))
