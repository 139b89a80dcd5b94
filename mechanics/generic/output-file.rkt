#lang racket/base
;; Files that are written for readers, pictures, pages and tables: the formats that names tell, and
;; writing them whole or not at all.

(require racket/file
         racket/path
         "wrong-argument.rkt"
         "../error/complain.rkt" "../error/machine-limits.rkt")

(provide format-of-file check-file write-file call-writing-file)

;; formats : ((extension . format) ...), such as #".png"; listed : as a message lists them
(define (format-of-file who file formats listed)
  (check-argument who path-string? file "the name of a file")
  (define extension (path-get-extension file))
  (cond [(and extension (assoc (string->bytes/utf-8
                                (string-downcase (bytes->string/utf-8 extension #\?)))
                               formats))
         => cdr]
        [else
         (complain-showing
          who (format "the name of the file says no format; it ends in ~a" listed)
          "file" file)]))

;; Complains before anything is computed.  why-not : returns why nothing can be drawn, or #f
(define (check-file who file [why-not (lambda () #f)])
  (define folder (path-only (path->complete-path file)))
  (unless (directory-exists? folder)
    (raise-not-written who "there is no such folder" file (path->string folder)))
  (when (directory-exists? file)
    (raise-not-written who "there is a folder of that name" file #f))
  (define reason (why-not))
  (when reason
    (raise-not-written who "pictures cannot be drawn on this machine" file reason)))

;; The file is written whole or not at all.
(define (write-file who file bytes)
  (call-writing-file who file (lambda (port) (void (write-bytes bytes port)))))

;; write : port -> void
(define (call-writing-file who file write)
  (define (failed e) (raise-not-written who "the file cannot be written" file (exn-message e)))
  (with-handlers ([exn:fail:filesystem? failed])
    (call-with-atomic-output-file file (lambda (port path) (write port)))))

(define (raise-not-written who what file reason)
  (raise-unwritable who "~a\n  file: ~a~a" what file
                    (if reason (format "\n  reason: ~a" reason) "")))
