#lang racket/base
;; Where in the reader's own program an error happened: the form of the module that was being
;; evaluated, with its line, and functions of the reader's that were being called.  What lies
;; between, in libraries, is left out.
;;
;; The forms of a module leave marks (marked-line.rkt); the functions are those that Racket
;; finds on the stack, where calls in tail position leave no trace.

(require (only-in racket/file file->lines)
         (only-in racket/list add-between remove-duplicates take takef)
         (only-in racket/string string-join string-normalize-spaces)
         setup/dirs
         "marked-line.rkt")

(provide whereabouts of-library?)

;; exception -> lines to add to its message, or ""
(define (whereabouts e)
  (define marks (exn-continuation-marks e))
  (define line (marked-line marks))
  (define callers (own-functions marks))
  (string-append
   (if line (string-append "\n  in: " (line->text line)) "")
   (if (null? callers) "" (string-append "\n  within: " (apply string-append callers)))))

;; ---------------------------------------------------------------------------
;; The form

;; line : (source . number)
(define (line->text line)
  (define-values (source number) (values (car line) (cdr line)))
  (cond [(path? source)
         (define text (text-from-line source number))
         (format "~a, line ~a~a" (short source) number (if text (string-append ": " text) ""))]
        [else (format "line ~a" number)]))

(define longest-text 60)

;; The line and those that continue it, which are indented, as one that is not too long.
;; -> text, or #f if the file has changed or gone
(define (text-from-line file number)
  (define lines (with-handlers ([exn:fail:filesystem? (lambda (e) '())]) (file->lines file)))
  (and (<= number (length lines))
       (let* ([from (list-tail lines (sub1 number))]
              [form (cons (car from) (takef (cdr from) indented?))]
              [text (string-normalize-spaces (string-join form " "))])
         (if (> (string-length text) longest-text)
             (string-append (substring text 0 longest-text) " ...")
             text))))

(define (indented? line) (regexp-match? #px"^\\s+\\S" line))

(define (short file)
  (define-values (folder name directory?) (split-path file))
  (path->string name))

;; ---------------------------------------------------------------------------
;; Functions

(define most-functions 4)

;; -> texts, innermost first, with commas between
(define (own-functions marks)
  (define names
    (remove-duplicates
     (for*/list ([frame (in-list (continuation-mark-set->context marks))]
                 [text (in-value (own-function (car frame) (cdr frame)))]
                 #:when text)
       text)))
  (add-between (take names (min most-functions (length names))) ", "))

;; -> text or #f
(define (own-function name place)
  (define source (and place (srcloc-source place)))
  (cond [(not (and name (srcloc? place))) #f]
        [(not (written? name)) #f]
        [(eq? source 'prompt) (symbol->string name)]
        [(and (path? source) (not (of-library? source)))
         (format "~a (~a, line ~a)" name (short source) (srcloc-line place))]
        [else #f]))

;; Racket calls a function without a name after its place in the file.
(define (written? name) (not (regexp-match? #rx"[/:]|^body of" (symbol->string name))))

;; Does the file belong to this library, or to Racket's?
(define (of-library? source)
  (for/or ([folder (in-list (library-folders))])
    (and folder (within? (path->complete-path source) folder))))

(define (library-folders)
  (list (mechanics-folder) (find-collects-dir) (find-pkgs-dir) (find-user-pkgs-dir)))

(define (within? file folder)
  (define prefix (path->bytes (path->directory-path (simplify-path folder))))
  (define bytes (path->bytes (simplify-path file)))
  (and (> (bytes-length bytes) (bytes-length prefix))
       (equal? (subbytes bytes 0 (bytes-length prefix)) prefix)))

(define (mechanics-folder)
  (define here (variable-reference->module-source (#%variable-reference)))
  (and (path? here) (simplify-path (build-path here 'up 'up 'up))))
