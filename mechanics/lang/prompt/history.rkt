#lang racket/base
;; The entries of earlier sessions, in a file among the reader's preferences: a string a line.
;; Where the file cannot be read or written there is no history, and no complaint.

(require (only-in racket/file file->list make-parent-directory*)
         (only-in racket/list take-right))

(provide earlier-entries note-entry)

(define most-entries 1000)

(define (history-file)
  (build-path (find-system-path 'pref-dir) "mechanics-history.rktd"))

;; -> list of texts, latest last.  A file of more than twice as many entries is cut.
(define (earlier-entries [file (history-file)])
  (define entries (filter string? (quietly '() (lambda () (file->list file)))))
  (define wanted (take-right entries (min most-entries (length entries))))
  (when (> (length entries) (* 2 most-entries))
    (write-entries file wanted 'truncate/replace))
  wanted)

;; Writes the entry at once, so that no end of a session loses it.
(define (note-entry text [file (history-file)])
  (write-entries file (list text) 'append))

(define (write-entries file entries how)
  (quietly
   (void)
   (lambda ()
     (make-parent-directory* file)
     (call-with-output-file file #:exists how
       (lambda (port)
         (for ([text (in-list entries)]) (writeln text port)))))))

(define (quietly otherwise f)
  (with-handlers ([exn:fail:filesystem? (lambda (e) otherwise)]
                  [exn:fail:read? (lambda (e) otherwise)])
    (f)))
