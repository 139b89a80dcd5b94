#lang racket/base
;; New folders, that are gone after a test.

(require racket/file)

(provide with-folder)     ; (with-folder (name) body ...) : the value of the body

(define-syntax-rule (with-folder (folder) body ...)
  (call-with-folder (lambda (folder) body ...)))

(define (call-with-folder use)
  (define folder (make-temporary-file "mechanics-test-~a" 'directory))
  (dynamic-wind void (lambda () (use folder)) (lambda () (delete-directory/files folder))))
