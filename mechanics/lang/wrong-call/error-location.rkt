#lang racket/base
;; The place of an error in the reader's own program: the form of the module that was being
;; evaluated, with its line, and calls of the reader's functions.  Calls of libraries are left out.
;;
;; The forms of a module leave marks (marked-line.rkt); Racket finds the functions on the stack,
;; where calls in tail position leave no trace.

(require (only-in racket/file file->lines)
         (only-in racket/list add-between filter-map remove-duplicates take takef)
         (only-in racket/string string-join string-normalize-spaces string-prefix?)
         setup/dirs
         "marked-line.rkt")

(provide whereabouts lines-of of-library? of-mechanics?)

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

;; The line and the indented lines after it, as one line, shortened.
;; -> text, or #f if the file has changed or gone
(define (text-from-line file number)
  (define lines (lines-of file))
  (and (<= number (length lines))
       (let* ([from (list-tail lines (sub1 number))]
              [form (cons (car from) (takef (cdr from) indented?))]
              [text (string-normalize-spaces (string-join form " "))])
         (if (> (string-length text) longest-text)
             (string-append (substring text 0 longest-text) " ...")
             text))))

;; The lines of a file, none if it cannot be read.
(define (lines-of file)
  (with-handlers ([exn:fail:filesystem? (lambda (e) '())]) (file->lines file)))

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
     (filter-map (lambda (frame) (own-function (car frame) (cdr frame)))
                 (continuation-mark-set->context marks))))
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

;; Is the name written in the program?  Racket names other functions after their place in the file.
(define (written? name) (not (regexp-match? #rx"[/:]|^body of" (symbol->string name))))

;; Does the file belong to this library, or to Racket's?
(define (of-library? source)
  (or (of-mechanics? source)
      (for/or ([folder (in-list (list (find-collects-dir) (find-pkgs-dir) (find-user-pkgs-dir)))])
        (and folder (within? source folder)))))

(define (of-mechanics? source)
  (define here (variable-reference->module-source (#%variable-reference)))
  (and (path? here) (within? source (build-path here 'up 'up 'up))))

(define (within? file folder)
  (string-prefix? (path->string (simplify-path (path->complete-path file)))
                  (path->string (path->directory-path (simplify-path folder)))))
