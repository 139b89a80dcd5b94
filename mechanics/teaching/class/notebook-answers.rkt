#lang racket/base
;; A student's notebook: its cells with code, one after the other, are the program.
;;
;; Their sources count and nothing else: what a notebook shows as results anybody may have written.
;; Text and raw cells are not run.

(require racket/string
         "../../error/complain.rkt"
         "../../show/notebook/notebook-file.rkt" "../../show/notebook/program-cells.rkt")

(provide notebook-sources notebook-outline)

;; text : of a file that anybody may have written -> sources, texts; what is wrong is an exn:fail
(define (notebook-sources text)
  (for/list ([c (in-list (cells-of text))] #:when (eq? (cell-kind c) 'code)) (cell-source c)))

(define (cells-of text)
  (define-values (header cells)
    (bytes->notebook 'check "it" (string->bytes/utf-8 text) #:attachments? #f))
  (when (> (apply + (map (lambda (c) (string-length (cell-source c))) cells)) most-characters)
    (complain 'check "it has more than ~a characters in its cells" most-characters))
  cells)

;; As a program may have.
(define most-characters 1000000)

;; The lines that tell the author, as a program's comment would, and what is defined
(define (notebook-outline text)
  (define (lines-of c)
    (define lines (regexp-split #px"\r?\n" (cell-source c)))
    (case (cell-kind c)
      [(markdown) (filter values (map name-line lines))]
      [(code) (filter (lambda (line) (regexp-match? #px"^[(]define\\s|^;+ *Name:" line)) lines)]
      [else '()]))
  (string-join (apply append (map lines-of (cells-of text))) "\n"))

(define (name-line line)
  (define m (regexp-match #px"^[*_ ]*Name:[*_ ]*(.*)$" line))
  (and m (string-append ";; Name: " (cadr m))))
