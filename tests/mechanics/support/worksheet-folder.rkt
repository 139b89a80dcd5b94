#lang racket/base
;; A folder of worksheets and submissions, and `raco mechanics` run in it, in this process.

(require mechanics/lang/command/raco
         racket/file
         racket/list
         racket/string
         "checks.rkt")

(provide folder in-folder text write-text   ; (write-text name line ...)
         delete-folder
         command           ; (command argument ...) -> status, and what was printed
         answered          ; (answered text answers) : an answer for each name
         run-file          ; (run-file name) -> what the program prints
         check-refused     ; (check-refused pattern argument ...)
         check-worksheet)  ; (check-worksheet pattern line ...) : a worksheet with a mistake

(define folder (make-temporary-file "mechanics-worksheets~a" 'directory))
(define (delete-folder) (delete-directory/files folder))

(define (in-folder name) (build-path folder name))
(define (text name) (file->string (in-folder name)))
(define (write-text name . lines)
  (display-to-file #:exists 'truncate (string-join lines "\n") (in-folder name)))

;; Without the lines on isolation, which depend on the machine.
(define (command . arguments)
  (define out (open-output-string))
  (define status
    (parameterize ([current-output-port out] [current-error-port out] [current-directory folder])
      (run-command-line arguments)))
  (list status (regexp-replace #rx"^Submissions were run[^\n]*\n\n" (get-output-string out) "")))

;; answers : lists of a name and the text of its definition
(define (answered text answers)
  (for/fold ([text text]) ([a (in-list answers)])
    (string-replace text (format "(define ~a unanswered)" (first a))
                    (format "(define ~a ~a)" (first a) (second a)))))

(define (run-file name)
  (define out (open-output-string))
  (parameterize ([current-output-port out] [current-namespace (make-base-namespace)])
    (dynamic-require (in-folder name) #f))
  (get-output-string out))

(define (check-refused pattern . arguments)
  (define result (apply command arguments))
  (check-equal? (first result) 2 (format "~s" arguments))
  (check-regexp-match pattern (second result)))

;; Each is a module of its own, for what is wrong with it is said when it is made.
(define (check-worksheet pattern . lines)
  (define name (format "~a.rkt" (gensym 'bad)))
  (apply write-text name "#lang mechanics/worksheet" lines)
  (check-refused pattern "worksheet" name))
