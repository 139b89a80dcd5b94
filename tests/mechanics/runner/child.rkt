#lang racket/base
;; One test file in a process of its own:  racket child.rkt RESULT-FILE TEST-FILE
;;
;; runs the `test` submodule if there is one, otherwise the file, as `raco test`
;; does.  When the process ends, also if the file ends it, it writes
;; (passed failed (reason-to-skip ...)) to RESULT-FILE.

(require rackunit/log
         "../support/skip.rkt")

(define-values (result-file test-file)
  (apply values (vector->list (current-command-line-arguments))))

(define (write-result _)
  (define log (test-log))
  (with-output-to-file result-file #:exists 'truncate
    (lambda () (write (list (- (cdr log) (car log)) (car log) (skipped))))))

(define (submodule name)
  (define path `(submod (file ,test-file) ,name))
  (and (module-declared? path #t) path))

(void (plumber-add-flush! (current-plumber) write-result))
(current-command-line-arguments (vector))
(cond [(submodule 'configure-runtime) => (lambda (path) (dynamic-require path #f))])
(dynamic-require (or (submodule 'test) `(file ,test-file)) #f)
