#lang racket/base
;; One mutant and tests of it:  racket try-mutant.rkt FILE TEST SECONDS ...
;;
;; The changed text comes from the standard input.  The tests run one after another, in this
;; process, each with modules of its own, with the file as it is changed and all others as they
;; are compiled, until one fails.  The last line printed is the datum (killed TEST) or (survived).
;; A test that takes much more of the processor than its seconds will not end, and has noticed.
;;
;; A procedure so small that it was compiled into others' code is not replaced there.

(require racket/path
         racket/port
         rackunit/log
         "mutate.rkt"
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

;; -> does it notice?
(define (notices? test)
  (define before (failures))
  (with-handlers ([(lambda (x) (not (exn:break? x))) (lambda (x) #t)])
    (parameterize ([current-output-port (open-output-nowhere)]
                   [current-error-port (open-output-nowhere)]
                   [exit-handler (lambda (code) (error "the test ended the process"))])
      (run test))
    (> (failures) before)))

(define (answer verdict)
  (newline)
  (write verdict)
  (newline)
  (flush-output))

(define most-memory (* 1500 1024 1024))

;; Ends the process where the work takes too long, or too much memory.
(define (call-watched test seconds work)
  (define end (+ (current-process-milliseconds) (* 1000 (+ 10 (* 4 seconds)))))
  (define watch
    (thread (lambda ()
              (let look ()
                (sleep 0.5)
                (when (or (> (current-process-milliseconds) end)
                          (> (current-memory-use) most-memory))
                  (answer (list 'killed (string-append "it did not end: " test)))
                  (exit))
                (look)))))
  (begin0 (work) (kill-thread watch)))

(module+ main
  (define arguments (vector->list (current-command-line-arguments)))
  (define file (simple-form-path (car arguments)))
  (define text (port->string (current-input-port)))
  (define (killed-by? test seconds)
    (call-watched test seconds (lambda () (notices? test))))
  (answer
   (parameterize ([current-load/use-compiled (load-replaced file text (current-load/use-compiled))]
                  [use-compiled-file-check 'exists])
     (let try ([tests (cdr arguments)])
       (cond [(null? tests) '(survived)]
             [(killed-by? (car tests) (string->number (cadr tests))) (list 'killed (car tests))]
             [else (try (cddr tests))])))))
