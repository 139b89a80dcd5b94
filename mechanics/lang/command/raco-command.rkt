#lang racket/base
;; The commands of `raco mechanics`, and their list as it is printed.

(provide (struct-out command) find-command command-names print-commands print-command)

;; sentence : about its purpose
;; run      : strings -> the status to exit with: 0 all is well, 1 the program or the answers have
;;            mistakes, 2 the arguments make no sense
(struct command (name arguments sentence run))

(define (find-command name commands)
  (findf (lambda (c) (string=? name (command-name c))) commands))

(define (command-names commands)
  (for/list ([c (in-list commands)]) (string->symbol (command-name c))))

(define (print-commands commands)
  (printf "raco mechanics COMMAND ...\n\n")
  (for ([c (in-list commands)]) (printf "  ~a\n      ~a\n" (usage c) (command-sentence c)))
  (printf "\nIn a checkout, where raco knows no such command: make show FILE=... [OUT=...],\n")
  (printf "make tex FILE=... [OUT=...], make export FILE=... [TO=...], make repl; make new,\n")
  (printf "worksheet, handout FILE=...; and make check FILE=... [WORKSHEET=... REPORT=...].\n"))

(define (print-command c)
  (printf "raco mechanics ~a\n    ~a\n" (usage c) (command-sentence c)))

(define (usage c)
  (define arguments (command-arguments c))
  (string-append (command-name c) (if (string=? "" arguments) "" " ") arguments))
