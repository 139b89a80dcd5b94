#lang racket/base
;; One test file in a process of its own:
;;
;;     racket child.rkt RESULT-FILE TEST-FILE
;;
;; runs the `test` submodule if there is one, otherwise the file, as `raco test`
;; does, and writes (passed failed (reason ...)) to RESULT-FILE, also when the
;; file exits by itself.  The process ends with 0 unless the file asked for
;; something else; without a result it died.

(require rackunit/log
         "../support/skip.rkt")

(define (main result-file test-file)
  (define exit-process (exit-handler))
  (define (finish code raised)
    (write-result result-file raised)
    (exit-process code))
  (parameterize ([exit-handler (lambda (code) (finish code 0))]
                 [current-command-line-arguments (vector)])
    (define raised (run (path->complete-path test-file)))
    (finish 0 raised)))

;; The number of things raised, 0 or 1; to test nothing counts as one.
(define (run file)
  (with-handlers ([not-break? (lambda (e) (display-raised e) 1)])
    (require-submodule file 'configure-runtime)
    (define tests? (require-submodule file 'test))
    (unless tests? (dynamic-require file #f))
    ((executable-yield-handler) 0)
    (cond [(or (tested?) (and (not tests?) (helper? file))) 0]
          [else (printf "~a ran no test\n" file)
                1])))

(define (tested?)
  (or (> (cdr (test-log)) 0) (pair? (skipped))))

;; Does the module provide anything, for others to test with?
(define (helper? file)
  (define-values (variables syntaxes) (module->exports file))
  (pair? (append variables syntaxes)))

(define (not-break? e) (not (exn:break? e)))

(define (require-submodule file name)
  (define path `(submod ,file ,name))
  (and (module-declared? path #t)
       (begin (dynamic-require path #f) #t)))

(define (display-raised e)
  ((error-display-handler)
   (if (exn? e) (exn-message e) (format "raised: ~e" e))
   e))

(define (write-result result-file raised)
  (define log (test-log))
  (define failed (car log))
  (define passed (- (cdr log) failed))
  (with-output-to-file result-file #:exists 'truncate
    (lambda () (write (list passed (+ failed raised) (skipped))))))

(module+ main
  (define arguments (current-command-line-arguments))
  (main (vector-ref arguments 0) (vector-ref arguments 1)))
