#lang racket/base
;; A system written as a program in another language, from the instruction list that our own
;; code is made of.
;;
;; A new folder is written whole or not at all; in one that is there only files of an export are
;; written over.
;;
;; While `raco mechanics export` runs a program nothing is written: the command receives the
;; systems, and writes those that are asked for.

(require racket/file
         racket/path
         "C.rkt" "JAX.rkt" "exported-branch.rkt" "exported-system.rkt" "python.rkt"
         "variable-names.rkt"
         "../../algebra/expression/symbols.rkt"
         (only-in "../../dynamics/continuation/branch.rkt" branch?)
         "../../error/complain.rkt" "../../error/machine-limits.rkt"
         "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/up-down.rkt")

(provide export-system
         ;; for a system that is ready
         write-exported
         ;; for the command
         call-receiving-exports)

(define who 'export-system)

;; exported -> void, or #f where export-system writes
(define receiver (make-parameter #f))

(define (call-receiving-exports receive use) (parameterize ([receiver receive]) (use)))

;; derivative : state -> state, or a branch; example : a state of numbers, or of symbols to name
;; variables
;; -> the folder's name, complete
(define-plain (export-system derivative example
                             #:language [target 'C]
                             #:name [name "motion"]
                             #:folder [folder (default-folder name target)]
                             #:parameters [parameters #f]
                             #:derivatives? [derivatives? #f]
                             #:replace? [replace? #f])
  (files-for target)                    ; complains of a language that is unknown
  (define text (checked-name name))
  (check-order parameters)
  (when (and (tuple? derivative) (not (tuple? example)))
    (complain who "the state derivative comes first, then an example of a state\n  given first: ~a"
              (describe-with-value derivative)))
  (define make (if (branch? derivative) make-exported-branch make-exported))
  (define (ready) (make who derivative example text parameters derivatives?))
  (cond [(receiver) => (lambda (receive) (receive (ready)) (format "~a" folder))]
        [else (path->string (write-exported who (ready) target folder replace? "#:replace? #t"))]))

;; s : exported; again : the text to be typed to write over an export -> the folder
(define (write-exported who s target folder replace? again)
  (define to (checked-folder who folder replace? again))
  (write-folder who to (append ((files-for target) who s) (exported-tables s)))
  to)

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
              (string-append "expected a name of letters, digits and _ that is no word of C or"
                             " Python, for files and functions\n  given: ~s")
              name))
  text)

(define (default-folder name target) (format "~a-~a" name target))

(define (check-order parameters)
  (unless (or (not parameters) (and (list? parameters) (andmap free-symbol? parameters)))
    (complain who "expected the parameters as a list of symbols, such as '(m l g)\n  given: ~a"
              (value->text parameters))))

(define (checked-folder who folder replace? again)
  (unless (path-string? folder)
    (complain who "expected the name of a folder\n  given: ~a" (value->text folder)))
  (define to (simple-form-path folder))
  (when (file-exists? to) (complain who "there is a file of that name\n  folder: ~a" folder))
  (when (and (directory-exists? to) (pair? (directory-list to)))
    (check-old who to folder replace? again))
  to)

;; Only files that an export has written are written over.
(define (check-old who to folder replace? again)
  (cond [(not (file-exists? (build-path to list-file)))
         (complain who
                   (string-append "the folder holds something else than an exported system; it is"
                                  " left as it is\n  folder: ~a")
                   folder)]
        [(not replace?)
         (complain who "the folder is there already\n  folder: ~a\n  to write it anew: ~a"
                   folder again)]))

;; In each exported folder: the names of the files that were written.
(define list-file ".exported")

;; files : alist of names and texts
(define (write-folder who to files)
  (define all (append files (list (cons list-file (names->text (map car files))))))
  (define (refused e)
    (raise-unwritable who "the folder cannot be written\n  folder: ~a\n  reason: ~a"
                      to (exn-message e)))
  (with-handlers ([exn:fail:filesystem? refused])
    (if (directory-exists? to)
        (write-over to all)
        (write-whole who to all))))

(define (names->text names)
  (apply string-append (for/list ([n (in-list names)]) (string-append n "\n"))))

;; All or nothing: beside its place first, then moved there.
(define (write-whole who to files)
  (define beside (make-temporary-file ".export~a" 'directory (parent-of who to)))
  (with-handlers ([void (lambda (e)
                          (delete-directory/files beside #:must-exist? #f)
                          (raise e))])
    (write-files beside files)
    (rename-file-or-directory beside to)))

;; Deletes the files of the last export that this one does not write, and no others.
(define (write-over to files)
  (define listed (build-path to list-file))
  (when (file-exists? listed)
    (for ([name (in-list (file->lines listed))] #:unless (assoc name files))
      (define old (build-path to name))
      (when (file-exists? old) (delete-file old))))
  (write-files to files))

(define (write-files folder files)
  (for ([f (in-list files)])
    (define file (build-path folder (car f)))
    (make-directory* (path-only file))
    (call-with-atomic-output-file
     file (lambda (port path) (void (write-string (cdr f) port))))))

(define (parent-of who folder)
  (define parent (path-only folder))
  (unless (and parent (directory-exists? parent))
    (complain who "there is no such folder\n  folder: ~a" parent))
  parent)
