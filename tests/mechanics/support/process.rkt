#lang racket/base
;; Processes of the system, by their numbers.

(require racket/file
         racket/port
         racket/system
         "patience.rkt")

(provide gone?)

;; A process that has been killed may take a moment to disappear.
(define (gone? number)
  (eventually (or (zombie? number) (not (alive? number)))))

;; Has it ended, and nobody asked how?  The first process of a container may never ask.
(define (zombie? number)
  (define file (format "/proc/~a/stat" number))
  (with-handlers ([exn:fail:filesystem? (lambda (e) #f)])
    (regexp-match? #rx"[)] Z [^)]*$" (file->string file))))

(define (alive? number)
  (parameterize ([current-error-port (open-output-nowhere)])
    (system (format "kill -0 ~a" number))))
