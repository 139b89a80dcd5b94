#lang racket/base
;; A student's notebook: its cells with code, one after the other, are the program.
;;
;; Their sources count and nothing else: the results that a notebook shows anybody may have written.
;; Text and raw cells are not run.

(require racket/string
         "../../error/complain.rkt"
         "../../show/notebook/notebook-file.rkt" "../../show/notebook/program-cells.rkt")

(provide notebook-sources notebook-outline)

;; text : of a file that anybody may have written -> sources, texts; a mistake in it is an exn:fail
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

;; The lines that tell the author, as a program's comment would, and the definitions; then comments
(define (notebook-outline text)
  (define cells (cells-of text))
  (define (lines-of kind pattern)
    (for*/list ([c (in-list cells)] #:when (eq? kind (cell-kind c))
                [line (in-list (regexp-split #px"\r?\n" (cell-source c)))]
                #:when (regexp-match? pattern line))
      line))
  (string-join (append (map as-comment (lines-of 'markdown name-line))
                       (lines-of 'code #px"^[(]define\\s")
                       (lines-of 'code #px"^\\s*;"))
               "\n"))

(define name-line #px"^[*_ ]*Name:[*_ ]*(.*)$")
(define (as-comment line) (regexp-replace name-line line ";; Name: \\1"))
