#lang racket/base
;; The heading of a program: the comment at its beginning.
;;
;;     ;; Exercise 1.17 (SICM 1.6.2): a bead on a helical wire
;;     ;; Checked: the equation of motion in the angle about the axis
;;     ;; How: against a falling particle, with the wire as its coordinate

(require racket/file
         racket/list
         racket/string)

(provide opening-comment program-heading)

;; Lines without their semicolons.
(define (opening-comment file)
  (for/list ([l (in-list (takef (cdr (file->lines file)) comment-line?))])
    (substring l 3)))

(define (comment-line? line) (regexp-match? #px"^;; \\S" line))

;; The first sentence of the comment; "p." and "pp." end none.
(define (program-heading file)
  (define text (string-normalize-spaces (string-join (opening-comment file) " ")))
  (cond [(regexp-match #px"^.*?(?<![ (]p)(?<![ (]pp)[.?](?=\\s|$)" text) => car]
        [else (string-append text ".")]))
