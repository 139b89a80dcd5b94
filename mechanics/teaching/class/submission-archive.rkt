#lang racket/base
;; The submissions in a ZIP archive, as learning platforms deliver a class.
;;
;; Nothing is unpacked into the file system, so a path in the archive can lead nowhere: an entry is
;; read into memory, as far as a submission may be long, and its name is a name and no more.

(require file/unzip
         racket/list
         racket/string
         "submission.rkt"
         "../../error/complain.rkt"
         "../../show/typesetting/visible.rkt")

(provide archive->submissions)

(define most-entries 5000)

(define (archive->submissions who file)
  (define (refuse . _)
    (complain who "it is no ZIP archive, or a damaged one\n  file: ~a" file))
  (define directory (with-handlers ([exn:fail? refuse]) (read-zip-directory file)))
  (define all (remove-duplicates (zip-directory-entries directory)))
  (when (> (length all) most-entries)
    (complain who "the archive has ~a entries; at most ~a are read\n  file: ~a"
              (length all) most-entries file))
  (define-values (programs others) (partition program? (filter seen? (map named all))))
  (define common (common-folder programs))
  (define entries (map (lambda (e) (without-folder e common)) programs))
  (when (null? entries)
    (complain who (string-append "there is no submission, no file that ends with .rkt or .ipynb"
                                 "\n  archive: ~a")
              file))
  (define groups (group-by submission-of entries))
  (define without
    (without-any (map (lambda (e) (without-folder e common)) others) (map submission-of entries)))
  (sort (append (for/list ([g (in-list groups)]) (group->submission file directory g)) without)
        string<? #:key submission-order #:cache-keys? #t))

;; bytes : its name in the archive; parts : of its path, strings
(struct entry (bytes parts))

(define (named bytes)
  (entry bytes (string-split (visible (bytes->string/utf-8 bytes #\?)) #rx"[/\\\\]" #:trim? #f)))

;; Files that systems put beside others, and hidden files, are none.
(define (seen? e)
  (not (for/or ([p (in-list (entry-parts e))])
         (or (equal? p "__MACOSX") (equal? p "compiled") (regexp-match? #px"^[.][^./]" p)))))

(define (program? e) (submission-name? (entry-bytes e)))

;; The folders in which only other files were handed in
(define (without-any others ids)
  (define files
    (for/list ([e (in-list others)]
               #:unless (or (leads-out? e) (null? (cdr (entry-parts e)))
                            (member (submission-of e) ids)))
      e))
  (for/list ([g (in-list (group-by submission-of files))])
    (no-program (submission-of (first g)) (map (lambda (e) (last (entry-parts e))) g))))

(define (leads-out? e)
  (define parts (entry-parts e))
  (or (member ".." parts) (member "" parts) (member "." parts)
      (regexp-match? #rx"^[A-Za-z]:" (first parts))))

;; A folder that holds the whole class says nothing of anybody. -> its name, or #f
(define (common-folder entries)
  (define tops (remove-duplicates (map (lambda (e) (first (entry-parts e))) entries)))
  (and (pair? entries) (null? (cdr tops))
       (not (ormap leads-out? entries))
       (andmap (lambda (e) (pair? (cdr (entry-parts e)))) entries)
       (let ([inner (map (lambda (e) (without-folder e (first tops))) entries)])
         (pair? (cdr (remove-duplicates (map submission-of inner)))))
       (first tops)))

(define (without-folder e folder)
  (define parts (entry-parts e))
  (if (and folder (equal? folder (first parts)) (pair? (cdr parts)))
      (entry (entry-bytes e) (cdr parts))
      e))

;; The key of a submission's entries
(define (submission-of e)
  (define parts (entry-parts e))
  (cond [(leads-out? e) (string-join parts "/")]
        [(null? (cdr parts)) (regexp-replace #rx"[.](rkt|ipynb)$" (first parts) "")]
        [else (first parts)]))

(define (group->submission file directory g)
  (define id (submission-of (first g)))
  (cond [(ormap leads-out? g)
         (without-program id "its name leads out of the archive, and it was not read")]
        [(pair? (cdr g))
         (without-program id "the archive has several files of it that end with .rkt or .ipynb")]
        [else (read-entry file directory id (entry-bytes (first g)))]))

(define (read-entry file directory id bytes)
  (define notebook? (regexp-match? #rx#"[.]ipynb$" bytes))
  (define most (most-bytes notebook?))
  (define found #f)
  (let/ec return
    ;; a file that is too large is not unpacked further
    (define (keep name folder? in [time #f])
      (define content (read-bytes (+ most 1) in))
      (define bytes (if (eof-object? content) #"" content))
      (when (> (bytes-length bytes) most) (return (too-large id #f notebook?)))
      (set! found (bytes->submission id bytes notebook? time)))
    (with-handlers ([exn:fail? (lambda (x) (without-program id "it could not be unpacked"))])
      (unzip-entry file directory bytes keep #:preserve-timestamps? #t)
      found)))
