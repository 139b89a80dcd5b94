#lang racket/base
;; A teacher's worksheet, loaded from its file.

(require "../program-file.rkt"
         "../../error/complain.rkt" "../../error/spelling.rkt"
         "../../worksheet/exercise.rkt")

(provide load-worksheet worksheet-file? check-there)

;; The worksheets that are loaded share the library with this program.
(define-namespace-anchor here)

;; who : in whose name is complained
(define (load-worksheet who file)
  (check-there who file)
  (define w
    (parameterize ([current-namespace (namespace-anchor->empty-namespace here)]
                   [current-print void])
      (dynamic-require (path->complete-path file) 'worksheet (lambda () #f))))
  (unless (worksheet? w)
    (complain who (string-append "it is no worksheet: its first line should be "
                                 "#lang mechanics/worksheet\n  file: ~a")
              file))
  w)

(define (check-there who file)
  (unless (file-exists? file)
    (define near (near-programs file))
    (complain who "there is no such file~a\n  file: ~a"
              (if (null? near) "" (format "; did you mean ~a?" (alternatives near)))
              file)))

(define (worksheet-file? file)
  (and (file-exists? file)
       (regexp-match? #rx"^#lang +mechanics/worksheet" (call-with-input-file file first-line))))

(define (first-line in)
  (define l (read-bytes-line in 'any))
  (if (eof-object? l) #"" l))
