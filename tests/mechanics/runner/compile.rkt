#lang racket/base
;; Compiling the test files and all they require, in parallel.  Errors are not
;; shown here: a file that does not compile fails when it is run.

(require racket/future
         setup/parallel-build)

(provide compile-files)

(define (compile-files files)
  (define (ignore . _) (void))
  (void
   (parameterize ([current-output-port (open-output-nowhere)]
                  [current-error-port (open-output-nowhere)])
     (parallel-compile-files files
                             #:worker-count (max 2 (processor-count))
                             #:handler ignore))))

(define (open-output-nowhere)
  (make-output-port 'nowhere always-evt
                    (lambda (bytes from to wait? break?) (- to from))
                    void))
