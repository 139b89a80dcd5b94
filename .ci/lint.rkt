#lang racket/base
;; Rules for every source, file by file:
;;
;;     racket lint.rkt [--texts] [file-or-folder ...]
;;
;; - lines of at most 100 characters, but for a text (a message, say) that stands alone; no tabs,
;;   no spaces at ends of lines; one line end at the end of the file;
;; - no require of which no name stands in the module (required-names.rkt); what is excused from
;;   that is still there to be excused.
;;
;; Prints a line for each finding; the exit code is 1 if there are any.  Texts alone are read
;; in a second.

(require racket/cmdline
         racket/file
         racket/list
         racket/path
         racket/runtime-path
         racket/string
         "required-names.rkt")

(define widest 100)

(define-runtime-path here "lint.rkt")
(define-runtime-path top "..")
(define folders '("mechanics" "tests" "examples" "scribblings" ".ci"))

;; Kept for names that do not stand in the file, which a macro makes.  ((file . module) ...)
(define needed
  '(("mechanics/algebra/expression/operation.rkt" . "\"numeric-functions.rkt\"")))

;; ---------------------------------------------------------------------------
;; Files

(define (sources places)
  (append-map
   (lambda (place)
     (sort (find-files source? (simple-form-path place)) path<?))
   places))

;; The runner's fixtures are wrong on purpose.
(define (source? p)
  (and (or (path-has-extension? p #".rkt") (path-has-extension? p #".scrbl"))
       (file-exists? p)
       (not (regexp-match? #rx"/(compiled|fixture)/" (path->string p)))))

(define (short-name p) (path->string (find-relative-path (simple-form-path top) p)))

;; ---------------------------------------------------------------------------
;; Text

(define (check-text file)
  (define text (file->string file))
  (define (found line what) (format "~a:~a: ~a" (short-name file) line what))
  (append
   (for*/list ([(line i) (in-indexed (string-split text "\n" #:trim? #f))]
               [what (in-value (wrong-with line))]
               #:when what)
     (found (+ i 1) what))
   (if (regexp-match? #rx"[^\n]\n$|^$" text) '() (list (found "end" "not one line end")))))

;; A text on a line of its own: messages are found by whoever looks for them, unbroken.
(define alone #px"^ *[[(]?(#[rp]x)?\"([^\"\\\\]|\\\\.)*\"[])]*$")

(define (wrong-with line)
  (cond [(and (> (string-length line) widest) (not (regexp-match? alone line)))
         (format "~a characters, more than ~a" (string-length line) widest)]
        [(string-contains? line "\t") "a tab"]
        [(regexp-match? #rx" $" line) "spaces at the end"]
        [else #f]))

;; ---------------------------------------------------------------------------
;; Requires

;; A file that cannot be read or expanded is a finding, and the others are looked at.
(define (require-findings file)
  (with-handlers ([exn:fail? (lambda (e) (list (cannot-be-checked file (exn-message e))))])
    (define unneeded (unneeded-requires file))
    (define excused (for/list ([n (in-list needed)] #:when (equal? (car n) (short-name file)))
                      (cdr n)))
    (append (for/list ([module (in-list (remove* excused unneeded))])
              (format "~a: does not need ~a" (short-name file) module))
            (for/list ([module (in-list (remove* unneeded excused))])
              (format "~a: is excused for ~a without need" (short-name file) module)))))

(define (cannot-be-checked file reason)
  (format "~a: its requires cannot be checked: ~a" (short-name file)
          (string-replace reason "\n" " ")))

(define (unneeded-requires file)
  (for/list ([module (in-list (unnamed-requires file))]) (format "~s" module)))

;; A file that is no longer there needs no excuse.
(define (excuses-without-file)
  (for/list ([file (in-list (remove-duplicates (map car needed)))]
             #:unless (file-exists? (build-path top file)))
    (format "~a: is excused, and is not there" file)))

;; ---------------------------------------------------------------------------

(module+ main
  (define texts-only? #f)
  (define given
    (command-line
     #:program "lint"
     #:once-each
     [("--texts") "only what stands in the files' texts" (set! texts-only? #t)]
     #:args places places))
  (define files
    (sources (if (null? given) (map (lambda (f) (build-path top f)) folders) given)))
  (define modules (filter (lambda (p) (path-has-extension? p #".rkt")) files))
  (define findings
    (append (excuses-without-file)
            (append-map check-text files)
            (if texts-only? '() (append-map require-findings modules))))
  (for-each displayln findings)
  (printf "lint: ~a files, ~a findings\n" (length files) (length findings))
  (exit (if (null? findings) 0 1)))
