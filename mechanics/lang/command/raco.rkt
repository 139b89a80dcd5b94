#lang racket/base
;; The program of `raco mechanics COMMAND ARGUMENT ...` (../../info.rkt), and of `make show` and
;; `make tex` in a checkout: the command is looked up and run; mistakes are told briefly, as
;; terminal tools do.

(require "commands.rkt"
         "../../error/spelling.rkt")

(provide run-command-line)

;; arguments : list of strings -> status to exit with
(define (run-command-line arguments)
  (cond [(or (null? arguments) (member (car arguments) '("-h" "--help")))
         (print-commands)
         0]
        [(find-command (car arguments)) => (lambda (c) (run c (cdr arguments)))]
        [else
         (tell-unknown (car arguments))
         2]))

(define (run c arguments)
  (cond [(or (member "-h" arguments) (member "--help" arguments))
         (print-command c)
         0]
        [(member "" arguments)
         (tell-empty (command-name c) arguments)
         2]
        [else
         (with-handlers ([exn:fail? (lambda (e)
                                      (eprintf "~a\n" (exn-message e))
                                      2)])
           ((command-run c) arguments))]))

;; A shell gives an empty argument for a variable without a value.
(define (tell-empty name arguments)
  (define before
    (for/last ([a (in-list (cons name arguments))] [next (in-list arguments)]
               #:when (and (string=? next "") (regexp-match? #rx"^-" a)))
      a))
  (if before
      (eprintf "~a: what follows ~a is empty\n" name before)
      (eprintf "~a: which ~a? the name that was given is empty\n"
               name (if (string=? name "help") "name" "file"))))

(define (tell-unknown name)
  (eprintf "raco mechanics: ~a is no command~a\n" (if (string=? name "") "an empty name" name)
           (did-you-mean (nearest-names name command-names)))
  (eprintf "raco mechanics help lists them\n"))

(module+ main (exit (run-command-line (vector->list (current-command-line-arguments)))))
