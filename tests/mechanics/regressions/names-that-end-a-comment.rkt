#lang racket/base
;; A variable or a parameter whose name has */ in it ended the comment that tells the names, and
;; what was exported was no C.

(require racket/file
         racket/port
         racket/system
         mechanics
         mechanics/book
         "../support/checks.rkt")

(define here (make-temporary-file "names-~a" 'directory))
(define folder (build-path here "swing"))

(define (compiled? folder)
  (define compiler (or (find-executable-path "cc") (find-executable-path "gcc")))
  (or (not compiler)
      (for/and ([f (directory-list folder)] #:when (regexp-match? #rx"[.]c$" f))
        (parameterize ([current-directory folder] [current-output-port (open-output-nowhere)])
          (system* compiler "-std=c99" "-fsyntax-only" f)))))

(test-case "every name is C"
  (export-system (Lagrangian->state-derivative (L-pendulum '1a '|*/| '|a\nb|))
                 (up 't '|c"d| '|e*/f|) #:folder folder)
  (check-true (compiled? folder))
  (for ([f (directory-list folder #:build? #t)])
    (check-false (regexp-match? #rx"= [*]/" (file->string f)))))

(delete-directory/files here)
