#lang racket/base
;; A system as a package of Python: the C of it, called through ctypes, with arrays of NumPy, and
;; ensembles over a cluster of Dask.

(require racket/runtime-path
         racket/string
         "C.rkt" "exported-system.rkt" "template.rkt")

(provide python-files python-words)

(define-runtime-path python-folder "python")

;; -> alist of names of files and their texts
(define (python-files who s)
  (define name (exported-name s))
  (define words (python-words s))
  (define (filled file to) (cons to (fill-template (build-path python-folder file) words)))
  (append
   (list (filled "README.md" "README.md")
         (filled "pyproject.toml" "pyproject.toml")
         (filled "package.py" (in name "__init__.py"))
         (filled "ensemble.py" (in name "ensemble.py")))
   (for/list ([f (in-list (C-files who s))]) (cons (in (in name "csrc") (car f)) (cdr f)))))

(define (in folder file) (string-append folder "/" file))

;; By the words for them in the files of Python
(define (python-words s)
  (hash "NAME" (exported-name s)
        "DEFINITION" (python-text (exported-definition s))
        "VARIABLES" (python-tuple (exported-variables s))
        "PARAMETERS" (python-tuple (exported-parameters s))
        "CLOCK" (if (exported-clock? s) "True" "False")
        "JACOBIAN" (if (exported-jacobian s) "True" "False")))

;; Within a text in three quotation marks.
(define (python-text text) (string-replace (string-replace text "\\" "\\\\") "\"" "'"))

(define (python-tuple names)
  (string-append* `("(" ,@(for/list ([x (in-list names)]) (format "~s, " (format "~a" x))) ")")))
