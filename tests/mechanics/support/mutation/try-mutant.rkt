#lang racket/base
;; One mutant and tests of it:  racket try-mutant.rkt FILE TEST SECONDS ...
;;
;; The changed text comes from the standard input.  It is compiled into a folder that stands before
;; the compiled files, for this process and for all that its tests start.  The tests run one after
;; another, each with modules of its own, until one fails.  The last line printed is the datum
;; (killed TEST), (survived) or, of a text that is no program, (refused).  A test that takes much
;; more of the processor than its seconds, or leaves it alone for minutes, will not end, and has
;; noticed.

(require racket/file
         racket/path
         racket/port
         rackunit/log
         syntax/modread
         "mutations.rkt"
         "../../runner/module-space.rkt")

(define (failures) (car (test-log)))

(define (run test)
  (define path (path->complete-path test))
  (define space (make-module-space path))
  (define sub `(submod ,path test))
  (parameterize ([current-namespace (module-space-namespace space)]
                 [current-module-name-resolver (module-space-resolver space)]
                 [current-pseudo-random-generator (make-pseudo-random-generator)])
    (dynamic-require (if (module-declared? sub #t) sub path) #f)))

;; A port of the system, which processes that a test starts can write to
(define nowhere
  (open-output-file (if (eq? (system-type) 'windows) "NUL" "/dev/null") #:exists 'append))

;; -> does it notice?
(define (notices? test)
  (define before (failures))
  (with-handlers ([(lambda (x) (not (exn:break? x))) (lambda (x) #t)])
    (parameterize ([current-output-port nowhere]
                   [current-error-port nowhere]
                   [exit-handler (lambda (code) (error "the test ended the process"))])
      (run test))
    (> (failures) before)))

(define (answer verdict)
  (newline)
  (write verdict)
  (newline)
  (flush-output))

;; Bounds of a test: bytes, and milliseconds by the clock without work
(define most-memory (* 1500 1024 1024))
(define most-idle 180000)

;; Ends the process where the work takes too long, or too much memory, or waits for ever.  Looking
;; itself takes some 10 ms of a second.
(define (call-watched test seconds work)
  (define end (+ (current-process-milliseconds) (* 1000 (+ 10 (* 4 seconds)))))
  (define (look worked since)
    (sleep 0.5)
    (define used (current-process-milliseconds))
    (define now (current-inexact-milliseconds))
    (when (or (> used end) (> (current-memory-use) most-memory) (> (- now since) most-idle))
      (answer (list 'killed (string-append "it did not end: " test)))
      (exit))
    (if (> (- used worked) (* 1/20 (- now since))) (look used now) (look worked since)))
  (define watch
    (thread (lambda () (look (current-process-milliseconds) (current-inexact-milliseconds)))))
  (begin0 (work) (kill-thread watch)))

;; Puts the mutant of the file where its compiled code is looked for first; #f if it is no program.
(define (compiled-into? root file text)
  (with-handlers ([exn:fail? (lambda (e) #f)])
    (define code (compiled-text file text))
    (define-values (folder name _) (split-path (reroot-path file root)))
    (define compiled (build-path folder "compiled" (path-add-extension name #".zo")))
    (make-parent-directory* compiled)
    (call-with-output-file compiled (lambda (out) (write code out)))
    #t))

(define (compiled-text file text)
  (define form (check-module-form (program-of text file) 'mutant file))
  (parameterize ([current-namespace (make-base-empty-namespace)]
                 [current-load-relative-directory (path-only file)]
                 [current-module-declare-name (make-resolved-module-path file)])
    (compile form)))

(define (first-fails tests)
  (let try ([tests tests])
    (cond [(null? tests) '(survived)]
          [(call-watched (car tests) (string->number (cadr tests))
                         (lambda () (notices? (car tests))))
           (list 'killed (car tests))]
          [else (try (cddr tests))])))

(module+ main
  (define arguments (vector->list (current-command-line-arguments)))
  (define text (port->string (current-input-port)))
  (define root (make-temporary-file "mutant~a" 'directory))
  (void (plumber-add-flush! (current-plumber)
                            (lambda (_) (delete-directory/files root #:must-exist? #f))))
  (void (putenv "PLTCOMPILEDROOTS" (format "~a:" root))
        (putenv "PLT_COMPILED_FILE_CHECK" "exists"))
  (answer
   (parameterize ([current-compiled-file-roots (cons root (current-compiled-file-roots))]
                  [use-compiled-file-check 'exists])
     (if (compiled-into? root (simple-form-path (car arguments)) text)
         (first-fails (cdr arguments))
         '(refused)))))
