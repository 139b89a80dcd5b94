#lang racket/base
;; Submissions: the files of a folder, inspected before any of them is run.
;;
;; Each program of the folder, a file ending with .rkt, is a submission, and each notebook, ending
;; with .ipynb; and so is a folder in it that holds one such file, as learning platforms deliver
;; them.  Links are not followed.

(require (only-in racket/list filter-map)
         racket/path
         (only-in racket/string string-trim)
         "../../error/complain.rkt" (only-in "../../error/message-words.rkt" joined)
         "../../show/typesetting/visible.rkt")

(provide (struct-out submission)
         folder->submissions folder->submission file->submission bytes->submission
         without-program no-program too-large most-bytes submission-name? with-outline
         submission-order)

;; id      : string, by which it is listed
;; person  : the name in its line ";; Name:", or the id
;; text    : the program, or the notebook as it stands in its file, or #f
;; problem : why there is no program, or #f
;; time    : when the file was changed last, seconds since 1970, or #f
(struct submission (id person text problem notebook? time) #:transparent)

;; Pictures are in notebooks, too.
(define largest 1000000)
(define largest-notebook 4000000)

;; who : in whose name is complained
(define (folder->submissions who folder)
  (define (order name) (by-number (path->text name)))
  (define entries (sort (directory-list folder) string<? #:key order #:cache-keys? #t))
  (define found (filter-map (lambda (name) (entry->submission folder name entries)) entries))
  (when (null? found)
    (complain who "there is no submission, no file that ends with .rkt or .ipynb\n  folder: ~a"
              folder))
  found)

;; student-2 stands before student-10.
(define (by-number text)
  (define (filled digits)
    (string-append (make-string (max 0 (- 12 (string-length digits))) #\0) digits))
  (regexp-replace* #px"\\d+" text filled))

(define (submission-order s) (by-number (submission-id s)))

;; entries : of the folder; two files of one name keep their extensions
(define (entry->submission folder name entries)
  (define path (build-path folder name))
  (define id (path->text name))
  (define plain (regexp-replace #px"[.](?:rkt|ipynb)$" id ""))
  (define (also? extension) (member (string->path (string-append plain extension)) entries))
  (cond [(program? name)
         (file->submission path (if (and (also? ".rkt") (also? ".ipynb")) id plain))]
        [(link-exists? path) #f]
        [(directory-exists? path) (folder->submission path id)]
        [else #f]))

(define (folder->submission path id)
  (define programs (filter program? (directory-list path)))
  (cond [(hidden? id) #f]
        [(null? programs) (no-program id (map path->text (directory-list path)))]
        [(pair? (cdr programs))
         (without-program id "the folder has several files that end with .rkt or .ipynb")]
        [else (file->submission (build-path path (car programs)) id)]))

(define (without-program id problem) (submission id id #f problem #f #f))

;; others : names of the files that are there
(define (no-program id others)
  (define seen (filter (lambda (name) (not (hidden? name))) others))
  (without-program id (if (null? seen)
                          "the folder has no file that ends with .rkt or .ipynb"
                          (format "handed in ~a, ~a" (joined seen)
                                  (if (null? (cdr seen))
                                      "which is no program (.rkt) and no notebook (.ipynb)"
                                      "of which none is a program (.rkt) or a notebook (.ipynb)")))))

(define (program? name) (submission-name? (path->bytes name)))
(define (submission-name? bytes) (regexp-match? #rx#"[.](rkt|ipynb)$" bytes))
(define (notebook? path) (path-has-extension? path #".ipynb"))
(define (hidden? id) (or (regexp-match? #rx"^[.]" id) (equal? id "compiled")))

;; A name may be any bytes.
(define (path->text path) (visible (bytes->string/utf-8 (path->bytes path) #\?)))

(define (file->submission path [id (path->text (file-name-from-path path))])
  (define (problem text) (without-program id text))
  (define most (most-bytes (notebook? path)))
  (cond [(link-exists? path) (problem "it is a link to another place, and was not opened")]
        [(directory-exists? path) (problem "it is a folder, though its name ends as a file's")]
        [(not (file-exists? path)) (problem "there is no such file")]
        ;; a pipe or a device would be read without end
        [(not (eq? 'file (file-or-directory-type path))) (problem "it is no file of text")]
        [(> (file-size path) most) (too-large id (file-size path) (notebook? path))]
        [else (bytes->submission id (read-at-most path most) (notebook? path)
                                 (file-or-directory-modify-seconds path))]))

(define (most-bytes notebook?) (if notebook? largest-notebook largest))

;; size : or #f, where it is not known
(define (too-large id size notebook?)
  (define most (most-bytes notebook?))
  (without-program id (string-append (if size
                                         (format "it has ~a bytes; at most ~a are read" size most)
                                         (format "it has more than ~a bytes" most))
                                     (if notebook? about-outputs ""))))

(define about-outputs
  "; Clear Outputs of All Cells, in the menu Edit, and saving it make it smaller")

(define (read-at-most path most)
  (define bytes (call-with-input-file path (lambda (in) (read-bytes most in))))
  (if (eof-object? bytes) #"" bytes))

(define (bytes->submission id bytes notebook? time)
  (define text (with-handlers ([exn:fail:contract? (lambda (e) #f)]) (bytes->string/utf-8 bytes)))
  (cond [(not text) (without-program id "it is no text in UTF-8")]
        [(string=? "" (string-trim text)) (without-program id "it is empty")]
        ;; the contents of a notebook are told by the process that reads it
        [notebook? (submission id id text #f #t time)]
        [else (submission id (person-in text id) text #f #f time)]))

(define (person-in text id)
  (define m (regexp-match #px"(?m:^;+[ \t]*Name:[ \t]*([^\r\n]{1,80}))" text))
  (define name (if m (visible (string-trim (cadr m))) ""))
  (if (string=? name "") id name))

;; outline : the lines of a notebook that tell its author and its definitions
(define (with-outline s outline)
  (struct-copy submission s [person (person-in outline (submission-id s))] [text outline]))
