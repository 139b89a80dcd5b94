#lang racket/base
;; What every source keeps to, file by file:
;;
;;     racket lint.rkt [--texts] [file-or-folder ...]
;;
;; - lines of at most 100 characters, but for a text (a message, say) that stands alone; no tabs,
;;   no spaces at ends of lines; one line end at the end of the file;
;; - no require that the module does not need, as `raco check-requires` finds them; what is
;;   excused from that is still there to be excused.
;;
;; Prints a line for each finding; the exit code is 1 if there are any.  Texts alone are read
;; in a second: nothing is expanded or compiled for them.

(require racket/cmdline
         racket/file
         racket/future
         racket/lazy-require
         racket/list
         racket/path
         racket/port
         racket/runtime-path
         racket/string)

(lazy-require [macro-debugger/analysis/check-requires (show-requires)])

(define widest 100)

(define-runtime-path here "lint.rkt")
(define-runtime-path top "..")
(define folders '("mechanics" "tests" "examples" "scribblings" ".ci"))

;; Kept, though check-requires cannot see what for: programs run in the file's namespace.
;; ((file . module) ...)
(define needed
  '(("tests/mechanics/examples.rkt" . "mechanics/book")
    ("tests/mechanics/examples.rkt" . "mechanics/plot")
    ("tests/mechanics/show/plot/figures.rkt" . "mechanics/book")
    ("tests/mechanics/show/plot/figures.rkt" . "mechanics/plot")
    ("tests/mechanics/show/animation/programs.rkt" . "mechanics/animate")
    ("tests/mechanics/show/animation/programs.rkt" . "mechanics/book")))

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

;; Requires that macros bring in, or a language, do not stand in the file.  What a submodule
;; uses is not seen, so that a module with one is not judged.
(define (unneeded-requires file)
  (define text (file->string file))
  (for*/list ([entry (in-list (if (has-submodule? text) '() (show-requires file)))]
              #:when (eq? (car entry) 'drop)
              [module (in-value (format "~s" (cadr entry)))]
              #:when (string-contains? (without-language text) module))
    module))

(define (has-submodule? text) (regexp-match? #rx"[(]module[+*]" text))

;; `#lang racket/base` is no require.
(define (without-language text) (regexp-replace #rx"^#lang [^\n]*" text ""))

;; In several processes, as expanding takes its time.
(define (check-requires files)
  (define shares (filter pair? (deal files (processor-count))))
  (define children (map start-child shares))
  (append-map findings-of children))

(struct child (process out))

(define (start-child share)
  (define-values (process out in err)
    (apply subprocess #f #f (current-error-port)
           (find-executable-path (find-system-path 'exec-file)) here "--requires" share))
  (close-output-port in)
  (child process out))

;; What it found, and whether it came to its end.
(define (findings-of c)
  (define lines (port->lines (child-out c)))
  (subprocess-wait (child-process c))
  (define code (subprocess-status (child-process c)))
  (if (eqv? code 0)
      lines
      (append lines (list (format "lint: a check of requires ended with exit code ~a" code)))))

;; A file that is no longer there needs no excuse.
(define (excuses-without-file)
  (for/list ([file (in-list (remove-duplicates (map car needed)))]
             #:unless (file-exists? (build-path top file)))
    (format "~a: is excused, and is not there" file)))

(define (deal xs n)
  (for/list ([i (in-range n)])
    (for/list ([x (in-list xs)] [k (in-naturals)] #:when (= (modulo k n) i)) x)))

;; ---------------------------------------------------------------------------

(module+ main
  (define texts-only? #f)
  (define requires-only? #f)
  (define given
    (command-line
     #:program "lint"
     #:once-any
     [("--texts") "only what stands in the files' texts" (set! texts-only? #t)]
     [("--requires") "only requires, in this process" (set! requires-only? #t)]
     #:args places places))
  (define files
    (sources (if (null? given) (map (lambda (f) (build-path top f)) folders) given)))
  (define modules (filter (lambda (p) (path-has-extension? p #".rkt")) files))
  (cond [requires-only?
         (for-each displayln (append-map require-findings modules))]
        [else
         (define findings
           (append (excuses-without-file)
                   (append-map check-text files)
                   (if texts-only? '() (check-requires modules))))
         (for-each displayln findings)
         (printf "lint: ~a files, ~a findings\n" (length files) (length findings))
         (exit (if (null? findings) 0 1))]))
