#lang racket/base
;; Submissions: the files of a folder, inspected before any of them is run.
;;
;; Each program of the folder, a file ending with .rkt, is a submission, and so is a folder in it
;; that holds one such file, as learning platforms deliver them.  Links are not followed.

(require (only-in racket/list filter-map)
         racket/path
         (only-in racket/string string-trim)
         "../../error/complain.rkt")

(provide (struct-out submission) folder->submissions file->submission)

;; id      : string, by which it is listed
;; person  : the name in its line ";; Name:", or the id
;; text    : the program, or #f
;; problem : why there is no program, or #f
(struct submission (id person text problem) #:transparent)

(define largest 1000000)

;; who : in whose name is complained
(define (folder->submissions who folder)
  (define entries (sort (directory-list folder) string<? #:key by-number #:cache-keys? #t))
  (define found (filter-map (lambda (name) (entry->submission folder name)) entries))
  (when (null? found)
    (complain who "there is no submission, no file that ends with .rkt\n  folder: ~a" folder))
  found)

;; student-2 stands before student-10.
(define (by-number path)
  (define (filled digits)
    (string-append (make-string (max 0 (- 12 (string-length digits))) #\0) digits))
  (regexp-replace* #px"\\d+" (path->text path) filled))

(define (entry->submission folder name)
  (define path (build-path folder name))
  (define id (path->text name))
  (cond [(program? name) (file->submission path (regexp-replace #rx"[.]rkt$" id ""))]
        [(link-exists? path) #f]
        [(directory-exists? path) (subfolder->submission path id)]
        [else #f]))

(define (subfolder->submission path id)
  (define programs (filter program? (directory-list path)))
  (cond [(hidden? id) #f]
        [(null? programs) (without-program id "the folder has no file that ends with .rkt")]
        [(pair? (cdr programs))
         (without-program id "the folder has several files that end with .rkt")]
        [else (file->submission (build-path path (car programs)) id)]))

(define (without-program id problem) (submission id id #f problem))

(define (program? name) (regexp-match? #rx#"[.]rkt$" (path->bytes name)))
(define (hidden? id) (or (regexp-match? #rx"^[.]" id) (equal? id "compiled")))

;; A name may be any bytes.
(define (path->text path) (bytes->string/utf-8 (path->bytes path) #\?))

(define (file->submission path [id (path->text (file-name-from-path path))])
  (define (problem text) (without-program id text))
  (cond [(link-exists? path) (problem "it is a link to another place, and was not opened")]
        [(directory-exists? path) (problem "it is a folder, though its name ends with .rkt")]
        [(not (file-exists? path)) (problem "there is no such file")]
        ;; a pipe or a device would be read without end
        [(not (eq? 'file (file-or-directory-type path))) (problem "it is no file of text")]
        [(> (file-size path) largest)
         (problem (format "it has ~a bytes; at most ~a are read" (file-size path) largest))]
        [else (bytes->submission id (read-at-most path))]))

(define (read-at-most path)
  (define bytes (call-with-input-file path (lambda (in) (read-bytes largest in))))
  (if (eof-object? bytes) #"" bytes))

(define (bytes->submission id bytes)
  (define text (with-handlers ([exn:fail:contract? (lambda (e) #f)]) (bytes->string/utf-8 bytes)))
  (cond [(not text) (without-program id "it is no text in UTF-8")]
        [(string=? "" (string-trim text)) (without-program id "it is empty")]
        [else (submission id (person-in text id) text #f)]))

(define (person-in text id)
  (define m (regexp-match #px"(?m:^;+[ \t]*Name:[ \t]*([^\r\n]{1,80}))" text))
  (define name (if m (string-trim (cadr m)) ""))
  (if (string=? name "") id name))
