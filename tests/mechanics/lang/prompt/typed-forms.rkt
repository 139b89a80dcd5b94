#lang racket/base
;; Which texts are complete, and what is kept of them; the history file.

(require mechanics/lang/prompt/typed-forms mechanics/lang/prompt/lines
         racket/file
         "../../support/checks.rkt" "../../support/folder.rkt")

(define (data text) (map syntax->datum (forms-in text)))

(test-case "a text is complete when it ends outside of all forms"
  (check-equal? (data "") '())
  (check-equal? (data " ; nothing") '())
  (check-equal? (data "1 (a b) 'c") '(1 (a b) 'c))
  (for ([text '("(a" "[" "\"a" "(a \"b)" "'" "#| a" "#;" "(a . ")])
    (check-exn exn:fail:read:eof? (lambda () (data text)) text))
  (check-exn exn:fail:read? (lambda () (data ")")))
  (check-exn exn:fail:read? (lambda () (data "(a]"))))

(test-case "an entry of several lines is recalled as one, unless that would change it"
  (check-equal? (one-line "(a\n   b)\n") "(a b)")
  (check-equal? (one-line "(a ; why\n b)") "(a ; why\n b)")
  (check-equal? (one-line "\"a\n b\"") "\"a\n b\"")
  (check-equal? (one-line ")") ")"))

(test-case "entries are kept in the order in which they were made, in a folder that is made"
  (with-folder (folder)
    (define file (build-path folder "new" "history"))
    (check-equal? (earlier-entries file) '())
    (for ([text '("(f x)" "λ \"q\"" "(f x)")]) (note-entry text file))
    (check-equal? (earlier-entries file) '("(f x)" "λ \"q\"" "(f x)"))))

(test-case "a long history is cut from its beginning"
  (with-folder (folder)
    (define file (build-path folder "history"))
    (for ([i 2001]) (note-entry (number->string i) file))
    (check-equal? (length (earlier-entries file)) 1000)
    (check-equal? (car (file->list file)) "1001")))

(test-case "a file that cannot be read or written, or holds something else, is no error"
  (with-folder (folder)
    (note-entry "a" folder)
    (check-equal? (earlier-entries folder) '())
    (define file (build-path folder "history"))
    (display-to-file "(1 2) \"a\" )" file)
    (check-equal? (earlier-entries file) '())
    (display-to-file "(1 2) \"a\"" file #:exists 'truncate)
    (check-equal? (earlier-entries file) '("a"))))
