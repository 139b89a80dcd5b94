#lang racket/base
;; A teacher's worksheet, loaded from its file.

(require (only-in syntax/modcode get-module-code)
         "../program-file.rkt"
         "../../error/complain.rkt" "../../error/spelling.rkt"
         "../../teaching/worksheet/exercise.rkt" "../../teaching/worksheet/make-worksheet.rkt"
         "../../teaching/worksheet/student-numbers.rkt")

(provide load-worksheet worksheets-of-students files-required worksheet-file? check-there)

;; Loaded worksheets share the library with this program.
(define-namespace-anchor here)

;; who : in whose name is complained
(define (load-worksheet who file)
  (check-there who file)
  (unless (worksheet-file? file) (raise-no-worksheet who file))
  (define w
    (parameterize ([current-namespace (namespace-anchor->empty-namespace here)]
                   [current-print void])
      (dynamic-require (path->complete-path file) 'worksheet (lambda () #f))))
  (unless (worksheet? w) (raise-no-worksheet who file))
  w)

;; The worksheet of each student: its module is compiled once, and run once with their numbers.
;; try? : are the keys judged as answers?
;; -> procedure: name of a student -> worksheet
(define (worksheets-of-students who file #:try? [try? #f])
  (define general (load-worksheet who file))
  (define path (path->complete-path file))
  (define code (code-of path))
  (define (made name)
    (parameterize ([current-namespace (fresh-namespace)] [current-print void]
                   [trying-keys? try?]
                   [current-module-declare-name (make-resolved-module-path path)])
      (call-for-student name (lambda ()
                               (eval code)
                               (dynamic-require path 'worksheet)))))
  (define known (make-hash))
  (if (numbers-of general)
      (lambda (name) (hash-ref! known name (lambda () (made name))))
      (lambda (name) general)))

(define (code-of path)
  (parameterize ([current-namespace (fresh-namespace)]) (get-module-code path)))

(define (fresh-namespace)
  (define library (namespace-anchor->empty-namespace here))
  (parameterize ([current-namespace library]) (dynamic-require 'mechanics/worksheet #f))
  (define ns (make-base-empty-namespace))
  (namespace-attach-module library 'mechanics/worksheet ns)
  ns)

;; The teacher's own files that the worksheet requires, as it names them
(define (files-required file)
  (for*/list ([phase (in-list (module-compiled-imports (code-of (path->complete-path file))))]
              [index (in-list (cdr phase))]
              [name (in-value (call-with-values (lambda () (module-path-index-split index)) list))]
              #:when (string? (car name)))
    (car name)))

(define (raise-no-worksheet who file)
  (complain who (string-append "it is no worksheet: its first line should be "
                               "#lang mechanics/worksheet\n  file: ~a")
            file))

(define (check-there who file)
  (cond [(file-exists? file) (void)]
        [(directory-exists? file)
         (complain who "this is a folder; the programs in it: ~a\n  folder: ~a"
                   (programs-text file) file)]
        [else
         (define near (near-programs file))
         (complain who "there is no such file~a\n  file: ~a~a"
                   (did-you-mean near) file (if (null? near) (place-hint file) ""))]))

;; The folder of the file, which its name may not tell.
(define (place-hint file)
  (define-values (folder _name _folder?) (split-path (path->complete-path file)))
  (cond [(regexp-match? #rx"^~" file)
         "\n  ~ is the home folder to a shell alone; write the name of that folder"]
        [(not (directory-exists? folder)) (format "\n  there is no such folder: ~a" folder)]
        [else (format "\n  in the folder ~a\n  the programs in it: ~a"
                      folder (programs-text folder))]))

(define (worksheet-file? file)
  (and (file-exists? file)
       (call-with-input-file file (lambda (in) (regexp-match? language-line in)))))

(define language-line #px#"(?m:^#lang +mechanics/worksheet[ \t]*\r?$)")
