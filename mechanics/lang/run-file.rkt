#lang racket/base
;; What `make run FILE=... ARGS="..."` does: `racket -l mechanics/lang/run-file FILE ARGS`.
;;
;; As `racket FILE` would, but for what it says where there is no program in the file, or where
;; its parentheses do not match.

(require racket/list
         racket/string
         "mistake/spelling.rkt"
         (only-in "mistake/unbound.rkt" install-hints!)
         "../error/machine.rkt")

(provide run-file)

;; name : of a file; arguments : strings, for the program
(define (run-file name arguments)
  (define file (path->complete-path (string->path name)))
  (check-there name file)
  (check-language name file)
  (parameterize ([current-command-line-arguments (list->vector arguments)])
    (with-handlers ([exn:fail:read? (lambda (e) (raise-unreadable name e))])
      (module-declared? file #t))
    (require-submodule file 'configure-runtime)
    (dynamic-require file #f)
    (require-submodule file 'main)))

(define (require-submodule file name)
  (define submodule `(submod ,file ,name))
  (when (module-declared? submodule #t) (dynamic-require submodule #f)))

(define (refuse text . parts) (apply raise-unwritable 'run text parts))

;; ---------------------------------------------------------------------------
;; The file

(define (check-there name file)
  (cond [(file-exists? file) (void)]
        [(directory-exists? file)
         (refuse "~a is a folder; the programs in it: ~a" name (programs-text file))]
        [else
         (define-values (folder last-part must-be-folder?) (split-path file))
         (define near (likely-names (string->symbol (path->string last-part)) (programs folder)))
         (refuse "there is no file ~a~a" name
                 (if (null? near)
                     (format "; the programs in its folder: ~a" (programs-text folder))
                     (format "; did you mean ~a?" (alternatives near))))]))

;; -> symbols
(define (programs folder)
  (if (directory-exists? folder)
      (for*/list ([path (in-list (directory-list folder))]
                  [text (in-value (path->string path))]
                  #:when (regexp-match? #rx"[.]rkt$" text))
        (string->symbol text))
      '()))

(define most-shown 8)

(define (programs-text folder)
  (define names (map symbol->string (programs folder)))
  (cond [(null? names) "none"]
        [else (string-append (string-join (take names (min most-shown (length names))) ", ")
                             (if (> (length names) most-shown) ", ..." ""))]))

;; ---------------------------------------------------------------------------
;; The language

(define (check-language name file)
  (define language (language-of file))
  (cond [(not language)
         (refuse "~a does not say its language: its first line is to be  #lang mechanics" name)]
        [(not (known-language? language))
         (refuse "~a is in a language that is not installed: #lang ~a~a" name language
                 (if (memq 'mechanics (likely-names (string->symbol language) '(mechanics)))
                     "; did you mean #lang mechanics?"
                     ""))]))

;; Its name; "module" for a module that is written out; #f if the file is no module.
(define (language-of file)
  (define start (call-with-input-file file (lambda (port) (regexp-match first-form port))))
  (cond [(not start) #f]
        [(cadr start) (bytes->string/utf-8 (cadr start) #\?)]
        [else "module"]))

;; Behind comments.
(define first-form
  #px#"^(?:\\s+|;[^\n]*|#!/[^\n]*|#\\|.*?\\|#)*(?:#lang +([^\\s]+)|#![a-z]|\\(module\\s)")

(define (known-language? language)
  (with-handlers ([exn:fail? (lambda (e) #f)])
    (or (equal? language "module")
        (member language '("s-exp" "reader"))
        (let ([module (string->symbol language)])
          (or (module-declared? `(submod ,module reader) #t)
              (module-declared? (string->symbol (format "~a/lang/reader" language)) #t))))))

;; ---------------------------------------------------------------------------
;; Its parentheses

(define read-message #px"^.*?:([0-9]+):[0-9]+: read(?:-syntax)?: (.*)$")

(define (raise-unreadable name e)
  (define found (regexp-match read-message (exn-message e)))
  (if found
      (refuse "~a, line ~a: ~a" name (cadr found) (in-words (caddr found)))
      (raise e)))

(define (in-words text)
  (cond [(regexp-match #px"^expected a `(.)` to close `(.)`(?:\n  possible cause: (.*))?" text)
         => (lambda (found)
              (format "the ~a there is never closed~a" (caddr found)
                      (if (cadddr found) (string-append "\n  " (cadddr found)) "")))]
        [(regexp-match #px"^unexpected `(.)`" text)
         => (lambda (found) (format "there is a ~a too many" (cadr found)))]
        [(regexp-match? #px"^expected a closing `\"`" text) "the \" there has no other to close it"]
        [else text]))

(module+ main
  (install-hints!)
  (define arguments (vector->list (current-command-line-arguments)))
  (if (or (null? arguments) (string=? (car arguments) ""))
      (refuse "which file? as in  make run FILE=my-system.rkt")
      (run-file (car arguments) (cdr arguments))))
