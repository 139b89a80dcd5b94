#lang racket/base
;; The library as text: which files there are, and what stands in them.
;;
;; A file is named by its path from mechanics/, with slashes.

(require racket/file
         racket/path
         racket/runtime-path)

(provide library-root library-files library-folders full-path facade?
         read-module read-file file-text)

(define-runtime-path library "../../../../mechanics")
(define library-root (simple-form-path library))

;; All modules but info.rkt, which is data.
(define (library-files)
  (for/list ([name (in-list (names-under (lambda (p) (path-has-extension? p #".rkt"))))]
             #:unless (equal? name "info.rkt"))
    name))

;; All folders, those of compiled code apart.
(define (library-folders)
  (names-under directory-exists?))

(define (names-under wanted?)
  (for*/list ([p (in-list (find-files wanted? library-root))]
              [name (in-value (path->string (find-relative-path library-root p)))]
              #:unless (regexp-match? #rx"(^[.]$)|(^|/)compiled(/|$)" name))
    name))

(define (full-path name) (build-path library-root name))

;; A file directly in mechanics/.
(define (facade? name) (null? (cdr (explode-path name))))

(define (read-file path)
  (call-with-input-file path (lambda (port) (read-module port path))))

(define (read-module port name)
  (parameterize ([read-accept-reader #t]
                 [read-accept-lang #t])
    (port-count-lines! port)
    (read-syntax name port)))

(define (file-text name) (file->string (full-path name)))
