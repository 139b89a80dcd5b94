#lang racket/base
;; Findings of `make lint`, run on files made for it.

(require compiler/find-exe
         racket/file
         racket/port
         racket/runtime-path
         racket/string
         "support/checks.rkt" "support/folder.rkt")

(define-runtime-path lint "../../.ci/lint.rkt")

;; files : ((name . text) ...); options : those of the command, texts
;; -> exit code, lines without the folder
(define (lint-findings files . options)
  (with-folder (folder)
    (for ([file (in-list files)])
      (display-to-file (cdr file) (build-path folder (car file))))
    (apply run-lint folder options)))

(define (run-lint folder . options)
  (define-values (process out in err)
    (parameterize ([current-subprocess-custodian-mode 'kill])
      (apply subprocess #f #f (current-error-port) (find-exe) lint (append options (list folder)))))
  (close-output-port in)
  (define lines (port->lines out))
  (subprocess-wait process)
  (values (subprocess-status process)
          (for/list ([line (in-list lines)])
            (regexp-replace #rx"^[^ ]*/" line ""))))

(define sound "#lang racket/base\n(define x 1)\n")
(define idle "#lang racket/base\n(require racket/list)\n")
(define broken "#lang racket/base\n(require racket/no-such-library)\n")

;; ---------------------------------------------------------------------------

(test-case "a clean file has no findings"
  (define-values (code lines) (lint-findings (list (cons "a.rkt" sound))))
  (check-equal? code 0)
  (check-equal? lines '("lint: 1 files, 0 findings")))

(test-case "a file whose requires are not there is a finding, and hides none in the others"
  (define-values (code lines)
    (lint-findings (for/list ([name '("a.rkt" "b.rkt" "c.rkt" "d.rkt" "e.rkt" "f.rkt")]
                              [text (list broken broken idle idle idle idle)])
                     (cons name text))))
  (check-equal? code 1)
  (for ([name '("a.rkt" "b.rkt")])
    (check-true (ormap (lambda (line)
                         (string-prefix? line (string-append name ": its requires cannot")))
                       lines)
                name))
  (for ([name '("c.rkt" "d.rkt" "e.rkt" "f.rkt")])
    (check-not-false (member (string-append name ": does not need racket/list") lines) name)))

(test-case "lines, tabs and ends are looked at"
  (define text (string-append "#lang racket/base\n" (make-string 101 #\;) "\n;\t\n; \n\n"))
  (define-values (code lines) (lint-findings (list (cons "a.rkt" text))))
  (check-equal? code 1)
  (check-equal? lines '("a.rkt:2: 101 characters, more than 100" "a.rkt:3: a tab"
                        "a.rkt:4: spaces at the end" "a.rkt:end: not one line end"
                        "lint: 1 files, 4 findings")))

(test-case "a require passes of which a name stands in the file, by whatever name it goes there"
  (define text #<<end
#lang racket/base
(require (only-in racket/list [first head] last)
         (prefix-in s: racket/string)
         (rename-in racket/function [identity same])
         (except-in racket/math pi)
         (for-syntax racket/base racket/list)
         (for-label racket/port)
         racket/set)
(provide (all-from-out racket/set))
(define-syntax (m stx) (first (list #'last)))
(define texts (s:string-trim identity pi))
(module+ main (sgn 1))

end
    )
  (define-values (code lines) (lint-findings (list (cons "a.rkt" text))))
  (check-equal? code 1)
  (check-equal? lines '("a.rkt: does not need racket/function" "lint: 1 files, 1 findings")))

(test-case "texts alone: what is read is told, and no module is loaded"
  (define-values (code lines)
    (lint-findings (list (cons "a.rkt" sound) (cons "b.rkt" idle) (cons "c.rkt" broken))
                   "--texts"))
  (check-equal? code 0)
  (check-equal? lines '("lint: 3 files, 0 findings"))
  (define-values (code-of-long of-long)
    (lint-findings (list (cons "a.rkt" (make-string 101 #\;))) "--texts"))
  (check-equal? code-of-long 1)
  (check-equal? of-long '("a.rkt:1: 101 characters, more than 100" "a.rkt:end: not one line end"
                          "lint: 1 files, 2 findings")))
