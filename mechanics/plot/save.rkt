#lang racket/base
;; The picture of a frame as a file.

(require racket/file
         racket/path
         "frame.rkt" "on-demand.rkt"
         "../error/machine.rkt")

(provide graphics-save)

;; extension -> format
(define formats
  '((#".png" . png-bytes) (#".svg" . svg-bytes) (#".pdf" . pdf-bytes)))

;; The file is written whole or not at all.
(define (graphics-save f file)
  (check-frame 'graphics-save f)
  (unless (path-string? file)
    (raise-argument-error 'graphics-save "the name of a file" file))
  (define format (format-of file))
  (check-folder file)
  (check-drawing file)
  (define bytes (frame->bytes f format))
  (define (failed e) (raise-not-written "the file cannot be written" file (exn-message e)))
  (with-handlers ([exn:fail:filesystem? failed])
    (call-with-atomic-output-file
     file
     (lambda (port path) (void (write-bytes bytes port))))))

(define (format-of file)
  (define extension (path-get-extension file))
  (cond [(and extension (assoc (string->bytes/utf-8
                                (string-downcase (bytes->string/utf-8 extension #\?)))
                               formats))
         => cdr]
        [else
         (raise-arguments-error
          'graphics-save "the name of the file says no format; it ends in .png, .svg or .pdf"
          "file" file)]))

(define (check-folder file)
  (define folder (path-only (path->complete-path file)))
  (unless (directory-exists? folder)
    (raise-not-written "there is no such folder" file (path->string folder)))
  (when (directory-exists? file)
    (raise-not-written "there is a folder of that name" file #f)))

(define (check-drawing file)
  (define reason (why-not))
  (when reason
    (raise-not-written "pictures cannot be drawn on this machine" file reason)))

(define (raise-not-written what file reason)
  (raise-unwritable 'graphics-save "~a\n  file: ~a~a" what file
                    (if reason (format "\n  reason: ~a" reason) "")))
