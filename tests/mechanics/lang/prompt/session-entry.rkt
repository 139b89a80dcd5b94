#lang racket/base
;; Entries are the same whether lines come one by one, as at a prompt, or are at hand, as in a cell.

(require mechanics/lang/prompt/lines
         mechanics/lang/prompt/session-entry
         racket/string
         "../../support/checks.rkt")

;; -> list of the forms of each entry, and the message where one cannot be read
(define (entries text at-hand?)
  (define rest (string-split text "\n" #:trim? #f))
  (define (next prompt)
    (cond [(null? rest) eof]
          [else (begin0 (car rest) (set! rest (cdr rest)))]))
  (define (ahead k) (for/list ([line (in-list (if at-hand? rest '()))] [_ (in-range k)]) line))
  (define lines (line-source next void 'cell (lambda () 1) ahead))
  (with-handlers ([exn:fail? exn-message])
    (let loop ()
      (define e (read-entry lines))
      (if (eof-object? e) '() (cons (map syntax->datum (entry-forms e)) (loop))))))

(define texts
  (list "(+ 1\n 2)\n(+ 3\n\n 4) (+ 5\n 6) 7\n8"
        "#| a comment\n of lines |#\n(a)\n(b)"
        "(a) #| after\n a form |#\n(b\n c)"
        "(a #| within\n one |#\n b)\n(c)"
        "#;\n(a\n b)\n(c)"
        "\"a string\n of lines\" (a\n b)\n; (c\n(d)"
        "(a\n \"(\" #\\( |(|\n ; )\n)\n(b)"
        "(a\n (b\n"
        "(a\n ( . . )\n b)"
        "(a\n ]\n b)"
        "'(a\n b) '\n(c)"
        "(a\n b))\n(c)"))

(test-case "lines at hand make no difference"
  (for ([text (in-list texts)])
    (check-equal? (entries text #t) (entries text #f) text)))

(test-case "a form of thousands of lines is not read again with each of them"
  (define text (string-append* "(list\n" (for/list ([k 20000]) (format "(+ ~a\n 1)\n" k))))
  (define found (entries (string-append text ")\n(+ 1 1)") #t))
  (check-equal? (map length found) '(1 1))
  (check-equal? (length (caar found)) 20001))
