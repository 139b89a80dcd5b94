#lang racket/base
;; A system written as a program in another language, from the instruction list that our own
;; code is made of.
;;
;; A folder is written whole or not at all: beside its place first, then moved there.

(require racket/file
         racket/path
         "C.rkt" "JAX.rkt" "exported-system.rkt" "names.rkt" "python.rkt"
         "../algebra/expression/symbols.rkt"
         "../error/complain.rkt"
         "../generic/define-plain.rkt" "../generic/describe.rkt")

(provide export-system)

(define who 'export-system)

;; derivative : state -> state; example : a state of numbers, or of symbols to name variables
;; -> the folder's name, complete
(define-plain (export-system derivative example
                             #:to [target 'C]
                             #:name [name "motion"]
                             #:folder [folder (default-folder name target)]
                             #:parameters [parameters #f]
                             #:derivatives? [derivatives? #f]
                             #:replace? [replace? #f])
  (define files-of (files-for target))
  (define text (checked-name name))
  (check-order parameters)
  (define to (checked-folder folder replace?))
  (define s (make-exported who derivative example text parameters derivatives?))
  (write-folder to (files-of who s) replace?)
  (path->string to))

(define targets (list (cons 'C C-files) (cons 'python python-files) (cons 'JAX JAX-files)))

(define (files-for target)
  (define found (assq target targets))
  (unless found
    (complain who "there is no such target\n  targets: 'C, 'python, 'JAX\n  given: ~a"
              (value->text target)))
  (cdr found))

(define (checked-name name)
  (define text (if (symbol? name) (symbol->string name) name))
  (unless (and (string? text) (identifier? text))
    (complain who
              (string-append "expected a name of letters, digits and _, for files and functions"
                             "\n  given: ~s")
              name))
  text)

(define (default-folder name target) (format "~a-~a" name target))

(define (check-order parameters)
  (unless (or (not parameters) (and (list? parameters) (andmap free-symbol? parameters)))
    (complain who "expected the parameters as a list of symbols, such as '(m l g)\n  given: ~a"
              (value->text parameters))))

(define (checked-folder folder replace?)
  (unless (path-string? folder)
    (complain who "expected the name of a folder\n  given: ~a" (value->text folder)))
  (define to (simple-form-path folder))
  (when (file-exists? to) (complain who "there is a file of that name\n  folder: ~a" folder))
  (when (and (directory-exists? to) (pair? (directory-list to)) (not replace?))
    (complain who
              "the folder is there already\n  folder: ~a\n  to write it anew: #:replace? #t"
              folder))
  to)

;; files : alist of names and texts
(define (write-folder to files replace?)
  (define beside (make-temporary-file ".export~a" 'directory (parent-of to)))
  (with-handlers ([void (lambda (e)
                          (delete-directory/files beside #:must-exist? #f)
                          (raise e))])
    (for ([f (in-list files)])
      (define file (build-path beside (car f)))
      (make-directory* (path-only file))
      (call-with-output-file file (lambda (port) (void (write-string (cdr f) port)))))
    (when (directory-exists? to) (delete-directory/files to))
    (rename-file-or-directory beside to)))

(define (parent-of folder)
  (define parent (path-only folder))
  (unless (and parent (directory-exists? parent))
    (complain who "there is no such folder\n  folder: ~a" parent))
  parent)
