#lang racket/base
;; The lines at the prompt: from libedit, at a terminal where it is installed, with history and
;; completion; elsewhere they are read as they come.

(require (only-in racket/file file->list make-parent-directory*)
         (only-in racket/list take-right)
         (only-in racket/string string-prefix?)
         "typed-forms.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["editor.rkt" edit-line recall! complete-with!])

(provide (struct-out line-source)
         lines-at-hand completions
         ;; for tests
         earlier-entries note-entry)

;; next : prompt -> string or eof; remember : text of an entry -> void; who : reads the lines, for
;; messages; number : -> that of the next line; ahead : k -> the next k lines, as far as they are
;; there before they are asked for
(struct line-source (next remember who number ahead))

(define (prompt-lines next remember)
  (line-source next remember 'prompt (lambda () 1) (lambda (k) '())))

;; -> the best source there is; and whether libedit alone is missing for a better one
(define (lines-at-hand)
  (cond [(not (at-terminal?)) (values (plain-lines) #f)]
        [(editor-starts?) (values (edited-lines) #f)]
        [else (values (plain-lines) #t)]))

;; Only the loading of the editor can fail here.
(define (editor-starts?)
  (with-handlers ([exn:fail? (lambda (e) #f)])
    (complete-with! completions)
    #t))

;; Is it a terminal whose cursor can be moved?
(define (at-terminal?)
  (and (terminal-port? (current-input-port))
       (terminal-port? (current-output-port))
       (not (member (or (getenv "TERM") "dumb") '("" "dumb")))))

(define (edited-lines)
  (for-each recall! (earlier-entries))
  (prompt-lines edit-line
               (lambda (text)
                 (define entry (one-line text))
                 (recall! entry)
                 (note-entry entry))))

(define (plain-lines)
  (prompt-lines (lambda (prompt)
                 (write-string prompt)
                 (flush-output)
                 (read-line (current-input-port) 'any))
               void))

;; The names known at the prompt that begin so.
(define (completions beginning)
  (sort (filter (lambda (name) (string-prefix? name beginning))
                (map symbol->string (namespace-mapped-symbols)))
        string<?))

;; ---------------------------------------------------------------------------
;; History: the entries of earlier sessions, in a file among the reader's preferences, a string a
;; line.  Where the file cannot be read or written there is no history, and no complaint.

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
