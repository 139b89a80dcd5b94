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
  (unless (worksheet-file? file) (raise-no-worksheet who file))
  (define w
    (parameterize ([current-namespace (namespace-anchor->empty-namespace here)]
                   [current-print void])
      (dynamic-require (path->complete-path file) 'worksheet (lambda () #f))))
  (unless (worksheet? w) (raise-no-worksheet who file))
  w)

(define (raise-no-worksheet who file)
  (complain who (string-append "it is no worksheet: its first line should be "
                               "#lang mechanics/worksheet\n  file: ~a")
            file))

(define (check-there who file)
  (unless (file-exists? file)
    (define near (near-programs file))
    (complain who "there is no such file~a\n  file: ~a"
              (if (null? near) "" (format "; did you mean ~a?" (alternatives near)))
              file)))

(define (worksheet-file? file)
  (and (file-exists? file)
       (call-with-input-file file (lambda (in) (regexp-match? language-line in)))))

(define language-line #px#"(?m:^#lang +mechanics/worksheet[ \t]*\r?$)")
