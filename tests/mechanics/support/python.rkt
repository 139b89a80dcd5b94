#lang racket/base
;; The Python that exported systems are tried with: that of `make test-export`, that of
;; `make peers`, or the system's.

(require racket/port
         racket/runtime-path
         racket/system)

(provide python-with run-python)

(define-runtime-path own "../../../build/export/bin/python")
(define-runtime-path peers "../../../build/python/bin/python")

;; A Python that has these modules, or #f.
(define (python-with . modules)
  (for/first ([python (append (filter file-exists? (list own peers))
                              (list (find-executable-path "python3")))]
              #:when (and python (has? python modules)))
    python))

(define (has? python modules)
  (parameterize ([current-output-port (open-output-nowhere)]
                 [current-error-port (open-output-nowhere)])
    (system* python "-c" (apply string-append (for/list ([m modules]) (format "import ~a\n" m))))))

;; -> what the script prints, run in the folder; an error if it fails
(define (run-python python folder script)
  (define out (open-output-string))
  (define good?
    (parameterize ([current-directory folder]
                   [current-output-port out]
                   [current-error-port out]
                   [current-input-port (open-input-string "")])
      (system* python "-c" script)))
  (unless good? (error 'run-python "~a" (get-output-string out)))
  (get-output-string out))
