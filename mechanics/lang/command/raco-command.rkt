#lang racket/base
;; What a command of `raco mechanics` is, and how commands are listed.

(provide (struct-out command) find-command print-commands print-command)

;; sentence : what it does
;; run      : strings -> the status to exit with: 0 all is well, 1 the program or what was asked
;;            for is not, 2 what was typed makes no sense
(struct command (name arguments sentence run))

(define (find-command name commands)
  (for/first ([c (in-list commands)] #:when (string=? name (command-name c))) c))

(define (print-commands commands)
  (printf "raco mechanics COMMAND ...\n\n")
  (for ([c (in-list commands)]) (printf "  ~a\n      ~a\n" (usage c) (command-sentence c)))
  (printf "\nIn a checkout, where raco knows no such command: make show FILE=... [OUT=...],\n")
  (printf "make tex FILE=... [OUT=...], make export FILE=... [TO=...], make repl; make new,\n")
  (printf "worksheet, handout FILE=...; and make check FILE=... [WORKSHEET=... REPORT=...].\n"))

(define (print-command c)
  (printf "raco mechanics ~a\n    ~a\n" (usage c) (command-sentence c)))

(define (usage c)
  (if (string=? "" (command-arguments c))
      (command-name c)
      (string-append (command-name c) " " (command-arguments c))))
