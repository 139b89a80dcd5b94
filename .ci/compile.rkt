#lang racket/base
;; Compiles modules, several at a time where there are many, and says how far it is:
;;
;;     racket compile.rkt [--jobs N] [--DrRacket] [--root file ...] file-or-folder ...
;;
;; The roots are what matters: when all else is newer than its source, only what they stand
;; on is looked at, and only their errors are told.  An error elsewhere is left to whoever
;; runs the module: it is compiled again and fails there.  A folder that cannot be written, or a
;; full disk, ends the work at once with a sentence.

(require compiler/cm
         compiler/compilation-path
         racket/cmdline
         racket/file
         racket/lazy-require
         racket/list
         racket/path
         racket/port
         "DrRacket-files.rkt")

(lazy-require [setup/parallel-build (parallel-compile-files)])

(provide compile-files
         files-under         ; path -> (listof path): the modules below or at it
         compile-changed     ; folder, jobs, what -> ; raises the error of a file changed there
         show-progress       ; text -> ; in place of the last one at a terminal
         end-progress        ; ->
         outdated-files      ; paths -> those whose compiled form is not up to date
         raise-plainly       ; exception -> ; a mistake in a file without what led to it
         write-error-advice  ; message of an error -> what to do, or #f if it is not about writing
         read-only-advice    ; folder -> what to do
         unwritable-part)    ; folder -> the nearest existing folder above it, if that is not
                             ; writable; else #f

;; Hidden files, which editors make, are no modules.
(define (files-under path) (find-files module-file? path))

(define (module-file? path)
  (and (path-has-extension? path #".rkt")
       (not (regexp-match? #rx"^[.]|^info[.]rkt$" (path->string (file-name-from-path path))))))

;; Below this number, starting processes costs more than it saves.
(define fewest-in-parallel 15)

;; files : paths of modules; jobs : how many to compile at a time; what : text, such as
;; "the tests", or #f for silence; roots : those to make sure of.  Errors are not shown.
(define (compile-files files jobs what #:roots [roots files])
  (define to-do (to-compile files roots))
  (for-each check-writable to-do)
  (define out (if what (current-output-port) (open-output-nowhere)))
  (define done (make-semaphore))
  (define reporter (thread (lambda () (report-progress to-do what done out))))
  (dynamic-wind
   void
   (lambda () (compile-silently to-do roots jobs))
   (lambda ()
     (semaphore-post done)
     (thread-wait reporter))))

(define (compile-silently to-do roots jobs)
  (unless (or (< (length to-do) fewest-in-parallel) (< jobs 2))
    (compile-in-processes to-do jobs))
  (define nowhere (open-output-nowhere))
  (parameterize ([current-output-port nowhere] [current-error-port nowhere])
    (for ([file (in-list (append to-do roots))])
      (with-handlers ([exn:fail? (lambda (e) (stop-if-unwritable (exn-message e)))])
        (compile-file file)))))

;; Places would wait for each other at every collection of garbage: a third longer.  A process that
;; is through with its batches takes single files, from the far end.
(define (compile-in-processes files jobs)
  (define folder (make-temporary-file "compile~a" 'directory))
  (define (compile-all)
    (parallel-compile-files (append (write-batches files jobs folder) (reverse files))
                            #:worker-count jobs #:use-places? #f
                            #:handler (lambda (worker type work text out err)
                                        (stop-if-unwritable text))))
  (dynamic-wind
   void
   (lambda () (call-silently compile-all))
   (lambda () (delete-directory/files folder))))

(define (call-silently thunk)
  (call-with-output-file* (if (eq? (system-type) 'windows) "NUL" "/dev/null") #:exists 'append
    (lambda (null-device)
      (parameterize ([current-output-port null-device] [current-error-port null-device])
        (thunk)))))

;; Each file of parallel-compile-files has a namespace of its own, where all that it requires is
;; loaded again.  A batch is a module that names many files: they share the batch's namespace, and
;; tests then cost a fifth to a third less of the processor.
(define largest-batch 40)

(define (write-batches files jobs folder)
  (define size (max 1 (min largest-batch (quotient (length files) jobs))))
  (for/list ([start (in-range 0 (length files) size)])
    (define path (build-path folder (format "batch-~a.rkt" start)))
    (define rest (list-tail files start))
    (write-to-file (batch-of (take rest (min size (length rest)))) path)
    path))

(define (batch-of files)
  `(module batch '#%kernel
     (#%require ,@(for/list ([file (in-list files)])
                    `(for-meta #f (only (file ,(path->string file))))))))

(define compile-file
  (let ([compile (make-caching-managed-compile-zo)])
    (lambda (file)
      (parameterize ([current-namespace (make-base-empty-namespace)]) (compile file)))))

(define (compile-changed folder jobs what)
  (define changed (filter stale? (files-under folder)))
  (compile-files changed jobs what)
  (for-each compile-file changed))

;; A change of one file is one of all that require it.  Of these only the roots are looked for
;; where nothing was changed since it was compiled.
(define (to-compile files roots)
  (define stale (filter stale? files))
  (define concerned (if (null? stale) roots files))
  (append stale (filter out-of-date? (remove* stale concerned))))

(define (outdated-files files)
  (filter (lambda (file) (or (stale? file) (out-of-date? file))) files))

;; Would the compilation manager compile something for it?
(define out-of-date?
  (let ([compile (make-caching-managed-compile-zo)]
        [namespace (make-base-empty-namespace)])
    (lambda (file)
      (let/ec return
        (parameterize ([current-namespace namespace]
                       [manager-compile-notify-handler (lambda (_) (return #t))])
          (with-handlers ([exn:fail? (lambda (_) (return #t))]) (compile file))
          #f)))))

;; Is there no compiled form, or one older than the source?
(define (stale? file)
  (not (compiled-since? file (or (seconds file) +inf.0))))

(define (compiled-since? file time)
  (define compiled (seconds (get-compilation-bytecode-file file)))
  (and compiled (>= compiled time)))

(define (seconds path) (file-or-directory-modify-seconds path #f (lambda () #f)))

;; ---------------------------------------------------------------------------
;; Where nothing can be written

(define (check-writable file)
  (define-values (folder name must-be-folder?) (split-path (get-compilation-bytecode-file file)))
  (define part (unwritable-part folder))
  (when part (raise-user-error (read-only-advice part))))

(define (unwritable-part folder)
  (cond [(not (directory-exists? folder))
         (unwritable-part (simplify-path (build-path folder 'up)))]
        [(memq 'write (file-or-directory-permissions folder)) #f]
        [else folder]))

(define (read-only-advice folder)
  (format "~a may not be written by you, and what is compiled goes there.
  Its owner can run  make compile ; or do it in a copy of the checkout that is yours." folder))

(define full-disk-advice "The disk is full: what is compiled needs some 60 MB there.
  Make room, and run the same command again.")

;; Permission may be lacking to read as well; of that the error itself tells.
(define (write-error-advice text)
  (cond [(regexp-match? #rx"No space left on device|Disk quota exceeded" text) full-disk-advice]
        [(regexp-match? #rx"Permission denied|Read-only file system" text)
         (define part (unwritable-part (folder-named text)))
         (and part (read-only-advice part))]
        [else #f]))

;; The folder of the path that an error's message names.
(define (folder-named text)
  (define path (regexp-match #rx"\n *path: ([^\n]*)" text))
  (if path
      (simplify-path (build-path (path->complete-path (cadr path)) 'up))
      (current-directory)))

(define (raise-plainly e)
  (if (or (exn:fail:read? e) (exn:fail:syntax? e)) (raise-user-error (exn-message e)) (raise e)))

(define (stop-if-unwritable text)
  (define why (write-error-advice text))
  (when why (raise-user-error why)))

;; ---------------------------------------------------------------------------
;; Progress

(define before-first 3/2)        ; seconds of silence at the start, where there is nothing to do
(define (pause) (if (terminal-port? (current-output-port)) 1/2 5))

;; Until it is done: a line that is renewed at a terminal, lines elsewhere.
(define (report-progress files what done out)
  (define start (current-seconds))
  (define total (length files))
  (define (done-after? seconds) (sync/timeout seconds (semaphore-peek-evt done)))
  (parameterize ([current-output-port out])
    (unless (and (zero? total) (done-after? before-first))
      (printf "~a ~a ...\n" (beginning total) what)
      (let wait ([left files])
        (flush-output)
        (unless (done-after? (pause))
          (define still (filter (lambda (file) (not (compiled-since? file start))) left))
          (print-progress (- total (length still)) total (- (current-seconds) start))
          (wait still)))
      (end-progress))))

(define (beginning total)
  (case total
    [(0) "Looking at"]
    [(1) "Compiling 1 file of"]
    [else (format "Compiling ~a files of" total)]))

(define (print-progress done total seconds)
  (show-progress (if (zero? total)
                     (format "  ~a s" seconds)
                     (format "  ~a of ~a compiled, ~a s" done total seconds))))

(define (show-progress text)
  (printf (if (terminal-port? (current-output-port)) "\r\e[K~a" "~a\n") text)
  (flush-output))

(define (end-progress)
  (when (terminal-port? (current-output-port)) (printf "\r\e[K"))
  (flush-output))

(module+ main
  (define (compile-root file)
    (with-handlers ([exn:fail? (lambda (e)
                                 (stop-if-unwritable (exn-message e))
                                 (raise-plainly e))])
      (compile-file file)))
  (define jobs 2)
  (define DrRacket? #f)
  (define roots '())
  (define paths
    (command-line
     #:once-each
     [("-j" "--jobs") n "compile <n> files at a time" (set! jobs (string->number n))]
     ["--DrRacket" "for DrRacket, too, now and from now on" (set! DrRacket? #t)]
     #:multi
     [("-r" "--root") file "make sure of <file>"
                      (set! roots (cons (path->complete-path file) roots))]
     #:args paths
     paths))
  (compile-files (append-map files-under (map path->complete-path paths)) jobs "mechanics"
                 #:roots roots)
  (for-each compile-root roots)
  (for ([path (in-list paths)] #:when (or DrRacket? (linked-for-DrRacket? path)))
    (link-for-DrRacket path)))
