#lang racket/base
;; Program files, as they are given to `make run` and `make show`: does the file exist, which is its
;; language, and can it be read?

(require (only-in racket/file file->bytes)
         racket/list
         racket/path
         racket/string
         "unknown-name/unreadable.rkt"
         "../error/machine-limits.rkt" "../error/spelling.rkt")

(provide check-program raise-unreadable near-programs programs-text
         marked? call-with-program read-program read-whole-program
         language-without-us about-language)

;; ---------------------------------------------------------------------------
;; The file

;; who : in whose name is complained; name : of the file, as it was given
(define (check-program who name file)
  (define (refuse text . parts) (apply raise-unwritable who text parts))
  (check-there name file refuse)
  (unless (in-UTF-8? (file->bytes file))
    (refuse "~a is no text in UTF-8; save it as such" name))
  (check-language name file refuse))

(define (in-UTF-8? bytes) (and (bytes-utf-8-length bytes) #t))

(define (check-there name file refuse)
  (cond [(file-exists? file) (void)]
        [(directory-exists? file)
         (refuse "~a is a folder; the programs in it: ~a" name (programs-text file))]
        [else
         (define-values (folder last-part must-be-folder?) (split-path file))
         (define near (near-programs file))
         (refuse "there is no file ~a~a" name
                 (if (null? near)
                     (format "; the programs in its folder: ~a" (programs-text folder))
                     (did-you-mean near)))]))

;; file : missing -> symbols, programs in its folder with similar names
(define (near-programs file)
  (define-values (folder last-part must-be-folder?) (split-path (path->complete-path file)))
  (define name (if (path? last-part) (path->string last-part) ""))
  (define whole (string->symbol (string-append name ".rkt")))
  (define all (programs folder))
  (if (memq whole all) (list whole) (likely-names (string->symbol name) all)))

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

(define (check-language name file refuse)
  (define language (language-of file))
  (cond [(not language)
         (refuse "~a does not say its language: its first line is to be  #lang mechanics" name)]
        [(not (known-language? language))
         (refuse "~a is in a language that is not installed: #lang ~a~a" name language
                 (if (memq 'mechanics (likely-names (string->symbol language) '(mechanics)))
                     "; did you mean #lang mechanics?"
                     ""))]))

;; The name of the language; "module" for a module that is written out; #f if the file is no module.
(define (language-of file)
  (define start (call-with-program file (lambda (port) (regexp-match first-form port))))
  (cond [(not start) #f]
        [(cadr start) (bytes->string/utf-8 (cadr start) #\?)]
        [else "module"]))

;; Comments, and the beginning of a module behind them.
(define first-form
  #px#"^(?:\\s+|;[^\n]*|#!/[^\n]*|#\\|.*?\\|#)*(?:#lang +([^\\s]+)|#![a-z]|\\(module\\s)")

(define (known-language? language)
  (with-handlers ([exn:fail? (lambda (e) #f)])
    (or (equal? language "module")
        (member language '("s-exp" "reader"))
        (let ([module (string->symbol language)])
          (or (module-declared? `(submod ,module reader) #t)
              (module-declared? (string->symbol (format "~a/lang/reader" language)) #t))))))

;; Racket's language, if the program requires nothing of mechanics; or #f
(define (language-without-us file)
  (define language (language-of file))
  (and (member language '("racket" "racket/base"))
       (not (call-with-program file (lambda (port) (regexp-match? #rx#"mechanics" port))))
       language))

;; A note for the failure of a program without mechanics.
(define (about-language name language)
  (format "~a is in #lang ~a, without mechanics: begin it with  #lang mechanics" name language))

;; ---------------------------------------------------------------------------
;; Reading

(define mark #"\357\273\277")

;; Does the file begin with the mark of UTF-8 that some editors write?
(define (marked? file)
  (call-with-input-file file (lambda (port) (equal? (peek-bytes (bytes-length mark) 0 port) mark))))

;; read : port, behind the mark -> any
(define (call-with-program file read)
  (define begins-with-mark? (marked? file))
  (call-with-input-file file
    (lambda (port)
      (when begins-with-mark? (read-bytes (bytes-length mark) port))
      (read port))))

;; -> syntax of the first form, which in a program is a module
(define (read-program file port)
  (port-count-lines! port)
  (parameterize ([read-accept-reader #t] [read-accept-lang #t])
    (read-syntax file port)))

;; The same with messages of ours.
(define (read-whole-program who name file port)
  (with-handlers ([exn:fail:read? (lambda (e) (raise-unreadable who name e))])
    (parameterize ([current-load-relative-directory (path-only file)])
      (read-program file port))))

;; The message where parentheses do not match.
(define (raise-unreadable who name e)
  (define-values (line what) (unreadable e))
  (if line
      (raise-unwritable who "~a, line ~a: ~a" name line what)
      (raise-unwritable who "~a: ~a" name what)))
