#lang racket/base
;; One mutant and tests of it:  racket try-mutant.rkt FILE TEST ...
;;
;; The changed text comes from the standard input.  The tests run one after another, in this
;; process, each with modules of its own, with the file as it is changed and all others as they
;; are compiled, until one fails.  The last line printed is the datum (killed TEST) or (survived).
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

(module+ main
  (define arguments (vector->list (current-command-line-arguments)))
  (define file (simple-form-path (car arguments)))
  (define text (port->string (current-input-port)))
  (define verdict
    (parameterize ([current-load/use-compiled
                    (load-replaced file text (current-load/use-compiled))]
                   [use-compiled-file-check 'exists])
      (or (for/first ([t (in-list (cdr arguments))] #:when (notices? t)) (list 'killed t))
          '(survived))))
  (newline)
  (write verdict)
  (newline))
