#lang racket/base
;; Compiles modules, several at a time where there are many, and says how far it is:
;;
;;     racket compile.rkt [--jobs N] file-or-folder ...
;;
;; An error is left to whoever runs the module: it is compiled again and fails there.

(require compiler/cm
         racket/cmdline
         racket/list
         racket/port
         setup/parallel-build
         "discover.rkt")

(provide compile-files)

;; So few are sooner compiled one after another than processes are started.
(define few 15)

;; files : paths of modules; jobs : how many to compile at a time; what : text, such as
;; "the tests", or #f for silence
(define (compile-files files jobs what)
  (define to-do (filter stale? files))
  (define out (if what (current-output-port) (open-output-nowhere)))
  (define reporter (thread (lambda () (report-progress to-do what out))))
  (dynamic-wind
   void
   (lambda () (compile-silently to-do files jobs))
   (lambda ()
     (break-thread reporter)
     (thread-wait reporter))))

(define (compile-silently to-do files jobs)
  (define nowhere (open-output-nowhere))
  (parameterize ([current-output-port nowhere] [current-error-port nowhere])
    (if (or (< (length to-do) few) (< jobs 2))
        (compile-in-turn files)
        (parallel-compile-files (append to-do (remove* to-do files))
                                #:worker-count jobs #:handler void))))

(define (compile-in-turn files)
  (define compile-file (make-caching-managed-compile-zo))
  (parameterize ([current-namespace (make-base-empty-namespace)])
    (for ([file (in-list files)])
      (with-handlers ([exn:fail? void]) (compile-file file)))))

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

;; Until it is broken: a line that is renewed at a terminal, lines elsewhere.
(define (report-progress files what out)
  (define start (current-inexact-milliseconds))
  (define total (length files))
  (parameterize ([current-output-port out])
    (with-handlers ([exn:break? (lambda (e) (end-progress))])
      (when (zero? total) (sleep before-first))
      (printf "Compiling ~a ...~a\n" what (if (zero? total) "" (format " (~a files)" total)))
      (let loop ([left files])
        (flush-output)
        (sleep (pause))
        (define still (filter stale? left))
        (print-progress (- total (length still)) total start)
        (loop still)))))

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
  (define paths
    (command-line
     #:once-each
     [("-j" "--jobs") n "compile <n> files at a time" (set! jobs (string->number n))]
     #:args paths
     paths))
  (compile-files (append-map files-under (map path->complete-path paths)) jobs "mechanics"))
