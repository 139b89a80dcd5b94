#lang racket/base
;; Compiles modules, several at a time where there are many, and says how far it is:
;;
;;     racket compile.rkt [--jobs N] [--root file ...] file-or-folder ...
;;
;; The roots are what matters: when all else is newer than its source, only what they stand
;; on is looked at, and only their errors are told.  An error elsewhere is left to whoever
;; runs the module: it is compiled again and fails there.

(require compiler/cm
         racket/cmdline
         racket/lazy-require
         racket/list
         racket/port
         "discover.rkt")

(lazy-require [setup/parallel-build (parallel-compile-files)])

(provide compile-files)

;; So few are sooner compiled one after another than processes are started.
(define few 15)

;; files : paths of modules; jobs : how many to compile at a time; what : text, such as
;; "the tests", or #f for silence; roots : those to make sure of.  Errors are not shown.
(define (compile-files files jobs what #:roots [roots files])
  (define to-do (filter stale? files))
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
  (define nowhere (open-output-nowhere))
  (parameterize ([current-output-port nowhere] [current-error-port nowhere])
    (if (or (< (length to-do) few) (< jobs 2))
        (for ([file (in-list (append to-do roots))])
          (with-handlers ([exn:fail? void]) (compile-file file)))
        (parallel-compile-files (append to-do (remove* to-do roots))
                                #:worker-count jobs #:handler void))))

(define compile-file
  (let ([compile (make-caching-managed-compile-zo)])
    (lambda (file)
      (parameterize ([current-namespace (make-base-empty-namespace)]) (compile file)))))

;; Is there no compiled form, or one older than the source?
(define (stale? file)
  (define-values (folder name directory?) (split-path file))
  (define (seconds path) (file-or-directory-modify-seconds path #f (lambda () #f)))
  (define compiled
    (seconds (build-path folder "compiled" (path-add-extension name #".zo" #"_"))))
  (define source (seconds file))
  (not (and compiled source (>= compiled source))))

;; ---------------------------------------------------------------------------
;; Progress

(define before-first 3/2)        ; seconds of silence at the start, where there is nothing to do
(define (pause) (if (terminal-port? (current-output-port)) 1/2 5))

;; Until it is done: a line that is renewed at a terminal, lines elsewhere.
(define (report-progress files what done out)
  (define start (current-inexact-milliseconds))
  (define total (length files))
  (define (done-after? seconds) (sync/timeout seconds (semaphore-peek-evt done)))
  (parameterize ([current-output-port out])
    (unless (and (zero? total) (done-after? before-first))
      (printf "~a ~a ...\n" (beginning total) what)
      (let wait ([left files])
        (flush-output)
        (unless (done-after? (pause))
          (define still (filter stale? left))
          (print-progress (- total (length still)) total start)
          (wait still)))
      (end-progress))))

(define (beginning total)
  (case total
    [(0) "Looking at"]
    [(1) "Compiling 1 file of"]
    [else (format "Compiling ~a files of" total)]))

(define (print-progress done total start)
  (define seconds (quotient (round (inexact->exact (- (current-inexact-milliseconds) start))) 1000))
  (define text (if (zero? total)
                   (format "  ~a s" seconds)
                   (format "  ~a of ~a compiled, ~a s" done total seconds)))
  (if (terminal-port? (current-output-port))
      (printf "\r~a" text)
      (printf "~a\n" text)))

(define (end-progress)
  (when (terminal-port? (current-output-port)) (printf "\r\e[K"))
  (flush-output))

(module+ main
  (define jobs 2)
  (define roots '())
  (define paths
    (command-line
     #:once-each
     [("-j" "--jobs") n "compile <n> files at a time" (set! jobs (string->number n))]
     #:multi
     [("-r" "--root") file "make sure of <file>"
                      (set! roots (cons (path->complete-path file) roots))]
     #:args paths
     paths))
  (compile-files (append-map files-under (map path->complete-path paths)) jobs "mechanics"
                 #:roots roots)
  (for-each compile-file roots))
